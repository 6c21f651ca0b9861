import assert from 'node:assert/strict';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { drawn, launch, opened } from './browser.js';
import { inkOf } from './ink.js';
import { addFrames, attempt, csv, filesOf, hostile, records, run, smallStudy, study, withoutFindings } from './results.js';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const work = process.cwd();
const results = join(work, 'study');
const report = join(work, 'report.html');
const certificates = join(results, 'certificates');

let browser;

before(async () => {
  study(results);
  run('report', results, '--quiet', '--output', report);
  browser = await launch();
});
after(() => browser?.close());

// What the page carries, read from the file: not through its own scripts.
function carried(file) {
  const text = readFileSync(file, 'utf8');
  return JSON.parse(/<script type="application\/json" id="report">([^]*?)<\/script>/.exec(text)[1]);
}

function shownRows(page) {
  return page.$$eval('#trial-list tbody tr', (rows) => rows.map((row) => row.dataset.trial));
}

function column(page, heading) {
  return page.$$eval('#trial-list', ([table], words) => {
    const at = [...table.tHead.rows[0].cells].findIndex((cell) => cell.textContent.startsWith(words));
    return [...table.tBodies[0].rows].map((row) => row.cells[at].textContent);
  }, heading);
}

describe('the page of a study', () => {
  test('opens without a network, a request or a complaint, and soon', async () => {
    const { page, complaints, ms, close } = await opened(browser, report);
    await drawn(page);
    const megabytes = statSync(report).size / 1e6;
    console.log(`# ${megabytes.toFixed(2)} MB, ready after ${ms.toFixed(0)} ms`);
    assert.deepEqual(complaints, []);
    assert.ok(megabytes < 10);
    assert.match(await page.textContent('.banner'), /^SYNTHETIC data, seed 1/);
    assert.match(await page.title(), /^SYNTHETIC/);
    const policy = await page.getAttribute('meta[http-equiv="Content-Security-Policy"]', 'content');
    assert.match(policy, /^default-src 'none'; script-src 'sha256-[^']+'; style-src 'sha256-[^']+'/);
    assert.doesNotMatch(policy, /unsafe/);
    await close();
  });

  test('begins with the answer, and ends with how it was made', async () => {
    const { page, close } = await opened(browser, report);
    const sections = await page.$$eval('main > section', (all) => all.map((one) => one.id));
    assert.deepEqual(sections, ['summary', 'figures', 'trials-section', 'tables', 'left-out', 'provenance', 'methods']);
    for (const part of ['h1', 'h2', 'h3']) {
      const { rows, footnotes } = JSON.parse(readFileSync(join(results, part, 'findings.json'), 'utf8'));
      const title = part.toUpperCase();
      const card = page.locator('#summary .finding', { has: page.locator('h3', { hasText: new RegExp(`^${title}: `) }) });
      const shown = await card.locator('.findings li').evaluateAll((all) => all.map((one) => [...one.children].map((part) =>
        [...part.childNodes].map((node) => node.textContent)).flat()));
      assert.deepEqual(shown.map(([verdict, , evidence]) => [verdict, evidence]).sort(), rows.map((row) => [row.verdict, row.evidence]).sort());
      assert.ok(shown.every(([, about]) => rows.some((row) => row.about === `${title}, ${about}`)), `${shown}`);
      assert.deepEqual(await card.locator('.rule').allTextContents(), footnotes);
      assert.equal(await card.locator('.verdict').first().isVisible(), true);
    }
    // The verdicts are on the first screen; hypotheses stand before what only describes.
    assert.ok((await page.locator('.verdict').first().boundingBox()).y < 500);
    assert.match(await page.locator('#summary h3').first().textContent(), /^H1: /);
    assert.equal(await page.locator('#tables').getByText('What was found').count(), 0);
    const words = await page.$$eval('.glossary dt', (all) => all.map((one) => one.textContent));
    for (const word of ['T_t', 'V_t', 'm_t', 'S, G', 'TC_early', 'AUC', 'C', 'M3', 'CB-V']) assert.ok(words.includes(word), word);
    await close();
  });

  test('has the paper\'s Table 1, and its cells as numbers', async () => {
    const { page, close } = await opened(browser, report);
    const { tables } = carried(report);
    const one = tables.find((table) => table.name === 'table1');
    const rows = await page.$$eval(`#table-${one.id} tbody tr`, (all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
    assert.equal(rows.length, 7);
    const cells = records(join(certificates, 'study_cells.csv'));
    assert.equal(cells.length, 19);
    const lightings = one.columns.map((heading) => heading.heading);
    for (const cell of cells) {
      const shown = rows.find((row) => row[0] === cell.algorithm)[lightings.indexOf(cell.lighting)];
      assert.equal(shown, `${cell.successes}/${cell.known_outcomes} (${(100 * Number(cell.share)).toFixed(1)} %)`);
    }
    assert.equal(await page.locator('#tables').getByText(/^Policy-loop latency: median/).count(), 2);  // of the dealt trials, and of the driven ones
    await close();
  });

  test('has the score beside the row\'s name on a narrow screen', async () => {
    const { page, close } = await opened(browser, report, { width: 390 });
    assert.equal(await page.isVisible('.glossary dl'), false);
    await page.click('#summary a[href="#words"]');
    assert.equal(await page.isVisible('.glossary dl'), true);
    const { tables } = carried(report);
    for (const [name, first, score] of [['h1', 'predictor', 'AUC'], ['h2', 'lighting', 'AUC'], ['h1_time', 'predictor', 'C']]) {
      const { id, rows } = tables.find((table) => table.name === name);
      const headings = () => page.$$eval(`#table-${id} thead th`, (all) => all.map((cell) => cell.textContent));
      const narrow = await headings();
      assert.equal(narrow[0], first);
      assert.ok(narrow[1].startsWith(score), narrow[1]);
      assert.equal(narrow[2], 'panel');
      const box = await page.locator(`#table-${id} thead th:nth-child(2)`).boundingBox();
      assert.ok(box.x + box.width <= 390, `${name}: the score ends at ${box.x + box.width}`);
      const row = await page.$$eval(`#table-${id} tbody tr:first-child > *`, (all) => all.map((cell) => cell.textContent));
      assert.deepEqual([...row].sort(), [...rows[0]].sort());
      await page.setViewportSize({ width: 1280, height: 900 });
      await page.waitForFunction((table) => document.querySelector(`#table-${table} thead th`).textContent === 'panel', id);
      await page.setViewportSize({ width: 390, height: 900 });
    }
    await close();
  });

  test('shows every table with the cells of its text form and the bytes of its CSV', async () => {
    const { page, close } = await opened(browser, report);
    const { tables } = carried(report);
    assert.ok(tables.length >= 8);
    for (const table of tables) {
      const file = join(results, table.source, `${table.name}.csv`);
      assert.equal(table.csv, readFileSync(file, 'utf8'), file);
      const cells = await page.$$eval(`#table-${table.id} tbody tr`, (rows) =>
        rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
      assert.deepEqual(cells, table.rows, table.name);
    }
    await close();
  });

  test('draws every figure, and each from the numbers of its CSV', async () => {
    const { page, close } = await opened(browser, report);
    await drawn(page);
    const { figures } = carried(report);
    const states = await page.$$eval('figure[data-state]', (all) => all.map((figure) => figure.dataset.state));
    assert.deepEqual(states, figures.map(() => 'drawn'));
    for (const figure of figures) {
      const rows = csv(figure.csv);
      const { values } = figure.spec.data;
      assert.equal(values.length, rows.length - 1, figure.name);
      rows.slice(1).forEach((row, i) => rows[0].forEach((name, c) => {
        if (name === 'synthetic_seed') return; // The label, which the figure carries in words.
        const value = values[i][name];
        if (row[c] === '') assert.ok(value === null || value === '', `${figure.name} ${name} ${i}`);
        else assert.equal(typeof value === 'number' ? Number(row[c]) : row[c], value, `${figure.name} ${name} ${i}`);
      }));
      const marks = await page.$$eval(`#figure-${figure.id} .plot svg path, #figure-${figure.id} .plot svg line`, (all) => all.length);
      assert.ok(marks > 3, `${figure.name} has ${marks} marks`);
      await page.click(`#figure-${figure.id} summary`);
      await page.waitForSelector(`#figure-${figure.id} details tbody tr`); // Rows are made when it opens.
      const shown = await page.$$eval(`#figure-${figure.id} details tbody tr`, (all) =>
        all.map((row) => [...row.cells].map((cell) => cell.textContent)));
      assert.deepEqual(shown, rows.slice(1, 201).map((row) => row.map((cell) => (cell === '' ? 'NA' : cell))), figure.name);
    }
    await close();
  });

  test('leaves ink of every series of every figure, and dashes where a line is a guide', async () => {
    const { page, close } = await opened(browser, report);
    await drawn(page);
    const blank = await browser.newPage();
    const { figures } = carried(report);
    for (const figure of figures) {
      const svg = await page.$eval(`#figure-${figure.id} .plot svg`, (element) => new XMLSerializer().serializeToString(element));
      const layers = await blank.evaluate(inkOf, { svg, spec: figure.spec });
      assert.ok(layers.some((layer) => layer.rows > 0), figure.name);
      for (const layer of layers) {
        const words = `${figure.name}: ${JSON.stringify(layer)}`;
        if (layer.rows === 0) continue;
        assert.ok(layer.count > 0, words);
        if (['line', 'area'].includes(layer.kind) && layer.rows > 1) assert.ok(Math.max(layer.across, layer.up) > 20, words);
        if (layer.guide) assert.ok(layer.columns < 0.95 * layer.across, words);
      }
    }
    await blank.close();
    await close();
  });

  test('sorts and filters trials', async () => {
    const { page, close } = await opened(browser, report);
    const trials = records(join(certificates, 'features.csv'));
    assert.match(await page.textContent('.status'), new RegExp(`^1 to 25 of ${trials.length} trials`));
    const header = page.locator('#trial-list thead button', { hasText: /^time/ });
    await header.click();
    const times = trials.map((trial) => Number(trial.time_s)).sort((a, b) => a - b);
    const near = (shown, exact) => assert.ok(shown.length === exact.length
      && shown.every((text, i) => Math.abs(Number(text) - exact[i]) <= 0.05001), `${shown}\n${exact}`);
    near(await column(page, 'time'), times.slice(0, 25));
    assert.equal(await page.getAttribute('#trial-list th[aria-sort]', 'aria-sort'), 'ascending');
    await header.click();
    near(await column(page, 'time'), times.reverse().slice(0, 25));
    await page.locator('#filter-success').selectOption({ label: '0' });
    await page.fill('#trial-filter', 'dark');
    const left = trials.filter((trial) => trial.success === '0' && trial.lighting === 'Dark').length;
    assert.match(await page.textContent('.status'), new RegExp(`of ${left} trials, filtered from ${trials.length}`));
    await page.fill('#trial-filter', 'no such trial');
    assert.match(await page.textContent('.status'), /No trial passes/);
    await page.fill('#trial-filter', '');
    await page.locator('#filter-success').selectOption('');
    await page.click('.pager button:has-text("Last")');
    assert.match(await page.textContent('.status'), new RegExp(`to ${trials.length} of ${trials.length}`));
    await close();
  });

  test('opens a trial with the numbers of its series, and steps through it', async () => {
    const { page, complaints, close } = await opened(browser, report);
    await drawn(page);
    const times = [];
    for (const id of (await shownRows(page)).slice(0, 5)) {
      const ms = await page.evaluate(async (name) => {
        const start = performance.now();
        document.querySelector(`tr[data-trial="${name}"] button`).click();
        while (!document.querySelector('#trial-title')?.textContent.includes(name)) await new Promise(requestAnimationFrame);
        return performance.now() - start;
      }, id);
      times.push(ms);
    }
    console.log(`# opens a trial in ${times.map((ms) => ms.toFixed(0)).join(', ')} ms`);
    const [id] = await shownRows(page);
    await page.click(`tr[data-trial="${id}"] button`);
    await page.waitForFunction((name) => document.querySelector('#trial-title')?.textContent.endsWith(name), id);
    const ticks = records(join(certificates, 'series', `${id}.csv`));
    const readOut = () => page.$$eval('#readout div', (all) =>
      Object.fromEntries(all.map((one) => [one.children[0].textContent, one.children[1].textContent])));
    const names = { x: 'x_m', y: 'y_m', 'edge margin': 'edge_margin_m', 'tick margin m_t': 'margin_m', 'certificate T_t': 'certificate_m',
      'corridor value V_t': 'corridor_value_m', 'speed law': 'speed_law_mps', 'rays in contact': 'contacts', 'width w_t': 'width_m' };
    const last = Number(await page.getAttribute('#tick', 'max'));
    let compared = 0;
    for (const at of [0, 1, 2, Math.floor(last / 2), last]) {
      await page.fill('#tick', String(at));
      const shown = await readOut();
      const time = parseFloat(shown.time);
      const near = ticks.filter((tick) => Math.abs(Number(tick.time_s) - Number(ticks[0].time_s) - time) < 0.0051);
      assert.equal(near.length, 1, `${id} at ${time}`);
      for (const [heading, name] of Object.entries(names)) {
        if (near[0][name] === '') assert.equal(shown[heading], 'NA', `${heading} at ${time}`);
        else assert.ok(Math.abs(parseFloat(shown[heading]) - Number(near[0][name])) <= 0.00101, `${heading} at ${time}: ${shown[heading]}, ${near[0][name]}`);
        ++compared;
      }
    }
    assert.ok(compared >= 40);
    await page.fill('#tick', '0');
    const first = await page.getAttribute('.robot', 'transform');
    const cursors = () => page.$$eval('.u-cursor-x', (lines) => lines.map((line) => line.getBoundingClientRect().x));
    const [start] = await cursors();
    for (let i = 0; i < 5; ++i) await page.click('button[aria-label="Step forward"]');
    assert.equal(await page.inputValue('#tick'), '5');
    await page.click('button[aria-label="Step back"]');
    assert.equal(await page.inputValue('#tick'), '4');
    await page.selectOption('#speed', '64');
    await page.click('#play');
    await page.waitForFunction(() => Number(document.querySelector('#tick').value) > 50);
    assert.notEqual(await page.getAttribute('.robot', 'transform'), first);
    const moved = await cursors();
    assert.ok(moved.length >= 2 && moved.every((x) => x > start + 10 && Math.abs(x - moved[0]) < 3), `${start}: ${moved}`);
    await page.click('#play');
    // Another width, the same tick.
    await page.fill('#tick', String(Math.floor(last / 2)));
    const [before] = await cursors();
    await page.setViewportSize({ width: 1000, height: 900 });
    await page.waitForFunction((x) => {
      const [line] = document.querySelectorAll('.u-cursor-x');
      return line && Math.abs(line.getBoundingClientRect().x - x) > 5;
    }, before);
    await page.waitForFunction(() => [...document.querySelectorAll('.u-cursor-x')].every((line) => line.getBoundingClientRect().x > 500));
    await page.setViewportSize({ width: 1280, height: 900 });
    await page.waitForTimeout(300);
    for (const part of ['.map .contact', '.map .wall', '.map .odometry', '.map .edge', '.map .bottleneck', '.map .issued', '.map .start', '.map .goal']) {
      assert.ok(await page.locator(part).count() > 0, part);
    }
    // Pointing at a plot moves the robot; pointing at the map moves the cursor of the plots.
    await page.fill('#tick', '0');
    const plot = await page.locator('.u-over').first().boundingBox();
    await page.mouse.move(plot.x + plot.width / 2, plot.y + 20);
    await page.waitForFunction(() => Number(document.querySelector('#tick').value) > 20);
    const map = await page.locator('.map').boundingBox();
    await page.mouse.click(map.x + map.width / 2, map.y + map.height / 2);
    assert.deepEqual(complaints, []);
    await close();
  });

  test('keeps every peak and dip of a trial', async () => {
    const { page, close } = await opened(browser, report);
    const [id] = await shownRows(page);
    await page.click(`tr[data-trial="${id}"] button`);
    await page.waitForSelector('#tick');
    const ticks = records(join(certificates, 'series', `${id}.csv`));
    const last = Number(await page.getAttribute('#tick', 'max'));
    const all = await page.evaluate((end) => {
      const slider = document.querySelector('#tick');
      return Array.from({ length: end + 1 }, (_, tick) => {
        slider.value = tick;
        slider.dispatchEvent(new Event('input'));
        return Object.fromEntries([...document.querySelectorAll('#readout div')].map((one) =>
          [one.children[0].textContent, parseFloat(one.children[1].textContent)]));
      });
    }, last);
    for (const [heading, name] of [['tick margin m_t', 'margin_m'], ['corridor value V_t', 'corridor_value_m'], ['rays in contact', 'contacts'], ['y', 'y_m']]) {
      const file = ticks.map((tick) => tick[name]).filter((cell) => cell !== '').map(Number);
      const shown = all.map((tick) => tick[heading]).filter((value) => !Number.isNaN(value));
      assert.ok(Math.abs(Math.max(...file) - Math.max(...shown)) < 0.001, `largest ${name}`);
      assert.ok(Math.abs(Math.min(...file) - Math.min(...shown)) < 0.001, `smallest ${name}`);
    }
    await close();
  });

  test('works by keyboard alone', async () => {
    const { page, close } = await opened(browser, report);
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Skip to the content');
    await page.keyboard.press('Enter');
    await page.locator('#trial-list thead button').first().focus();
    await page.keyboard.press('Enter');
    assert.equal(await page.getAttribute('#trial-list th[aria-sort]', 'aria-sort'), 'descending');
    const [id] = await shownRows(page);
    for (let i = 0; i < 40; ++i) {
      await page.keyboard.press('Tab');
      if (await page.evaluate(() => document.activeElement.classList.contains('link'))) break;
    }
    await page.keyboard.press('Enter');
    await page.waitForFunction((name) => document.querySelector('#trial-title')?.textContent.endsWith(name), id);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'trial-title');
    for (let i = 0; i < 10; ++i) {
      await page.keyboard.press('Tab');
      if (await page.evaluate(() => document.activeElement.id === 'tick')) break;
    }
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    assert.equal(await page.inputValue('#tick'), '2');
    assert.match(await page.getAttribute('#tick', 'aria-valuetext'), /s$/);
    await close();
  });

  for (const [width, dark] of [[390, false], [390, true], [1280, false], [1280, true]]) {
    test(`is accessible, and fits, at ${width} px, ${dark ? 'dark' : 'light'}`, async () => {
      const { page, complaints, close } = await opened(browser, report, { width, dark });
      await page.click('#trial-list button.link');
      await page.waitForSelector('#tick');
      await drawn(page);
      // In the page's own frame its policy would forbid axe, rightly: it is run by the debugger.
      const { violations } = await (async () => {
        await page.evaluate(readFileSync(axe, 'utf8'));
        return page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
      })();
      assert.deepEqual(violations.map((one) => `${one.id}: ${one.nodes.slice(0, 3).map((node) => node.target).join(' | ')}`), []);
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(over <= 0, `wider than the screen by ${over} px`);
      const paper = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
      assert.equal(paper, dark ? 'rgb(20, 23, 26)' : 'rgb(255, 255, 255)');
      assert.deepEqual(complaints, []);
      await page.screenshot({ path: join(work, `page-${width}-${dark ? 'dark' : 'light'}.png`), fullPage: true });
      await close();
    });
  }

  test('prints', async () => {
    const { page, close } = await opened(browser, report);
    await drawn(page);
    await page.emulateMedia({ media: 'print' });
    assert.equal(await page.isVisible('.banner'), true);
    assert.equal(await page.isVisible('.filters'), false);
    const pdf = await page.pdf({ format: 'A4', path: join(work, 'report.pdf') });
    assert.ok(pdf.length > 100000);
    await close();
  });

  test('is the same file for any number of threads', () => {
    for (const threads of ['1', '2']) {
      run('report', results, '--quiet', '--threads', threads, '--output', join(work, `threads-${threads}.html`));
    }
    assert.ok(readFileSync(join(work, 'threads-1.html')).equals(readFileSync(join(work, 'threads-2.html'))));
  });
});

describe('the page of data that it cannot trust', () => {
  test('shows code in data as words, and draws what there is without courses', async () => {
    const small = smallStudy(join(results, 'corpus'), join(work, 'small'));
    addFrames(small.results, 4);
    const file = join(work, 'small.html');
    run('report', small.results, '--quiet', '--title', `Trials <b>${hostile}</b>`, '--output', file);
    const { page, complaints, close } = await opened(browser, file, { hash: '#trial=t0000001' });
    await page.waitForSelector('#tick');
    assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
    assert.equal(await page.locator('main img:not(.frame), main b').count(), 0);
    assert.deepEqual([...new Set(await column(page, 'algorithm'))], [hostile]);
    assert.ok((await page.textContent('.facts')).startsWith(hostile));
    assert.match(await page.textContent('#left-out'), /--bundle/);
    assert.match(await page.textContent('#trial-title'), /t0000001/);
    const [proof] = filesOf(join(small.results, 'witness'), '.json');
    const certain = await opened(browser, file, { hash: `#trial=${proof.replace('.json', '')}` });
    await certain.page.waitForSelector('.map polyline.witness');
    const drawn = await certain.page.locator('.map polyline.witness').boundingBox();
    assert.ok(drawn.width + drawn.height > 100, 'the path of the witness has a size');
    assert.equal(await certain.page.locator('.map circle.witness').count(), 1);
    await certain.close();

    const slider = page.locator('.frames input[type=range]');
    assert.equal(await slider.getAttribute('max'), '3');
    await slider.focus();
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => document.querySelector('.frame').alt.endsWith('step_001'));
    await page.waitForFunction(() => document.querySelector('.frame').naturalWidth === 200);
    assert.deepEqual(complaints, []);
    await close();
  });

  test('shows results of a version without findings, one folder under a title', async () => {
    const small = smallStudy(join(results, 'corpus'), join(work, 'older'));
    withoutFindings(small.results);
    const file = join(work, 'older.html');
    run('report', small.results, '--quiet', '--output', file);
    const { page, complaints, close } = await opened(browser, file);
    await drawn(page);
    assert.match(await page.textContent('#summary'), /hold no findings/);
    assert.equal(await page.textContent('#tables h3.group'), 'Certificates');
    // Somebody else's algorithm: nothing of the paper stands beside it.
    assert.equal(await page.locator('main').getByText(/[Pp]ublished/).count(), 0);
    assert.ok(!(await page.$$eval('.glossary dt', (all) => all.map((one) => one.textContent))).includes('M3'));
    assert.deepEqual(complaints, []);
    await close();
  });

  test('refuses a result that was edited, another bundle, and a file of somebody else', () => {
    const small = smallStudy(join(results, 'corpus'), join(work, 'edited'));
    const other = attempt('report', small.results, '--bundle', join(results, 'corpus'), '--output', join(work, 'no.html'));
    assert.equal(other.code, 65);
    assert.match(other.words, /is not the bundle/);
    const path = join(small.results, 'features.csv');
    writeFileSync(path, readFileSync(path, 'utf8').replace('1', '2'));
    const edited = attempt('report', small.results, '--output', join(work, 'no.html'));
    assert.equal(edited.code, 65);
    assert.match(edited.words, /features\.csv/);
    writeFileSync(join(work, 'mine.html'), 'mine');
    const mine = attempt('report', results, '--output', join(work, 'mine.html'));
    assert.equal(mine.code, 73);
    assert.equal(readFileSync(join(work, 'mine.html'), 'utf8'), 'mine');
    assert.equal(attempt('report', join(work, 'nowhere')).code, 66);
    assert.ok(filesOf(work, '.html').includes('report.html'));
  });
});
