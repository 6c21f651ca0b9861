// A browser without a network, and what it complains about.

import { chromium } from 'playwright-core';
import { pathToFileURL } from 'node:url';

export function launch() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM,
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync'],
  });
}

// Opens a file and waits until it says that it is ready, after `ms`. `complaints`: errors, warnings,
// requests.
export async function opened(browser, file, { width = 1280, height = 900, dark = false, hash = '' } = {}) {
  const context = await browser.newContext({
    viewport: { width, height }, colorScheme: dark ? 'dark' : 'light', reducedMotion: 'reduce', offline: true, acceptDownloads: true,
  });
  const page = await context.newPage();
  const complaints = [];
  const address = pathToFileURL(file).href;
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => complaints.push(`uncaught: ${error.message}`));
  page.on('request', (request) => {
    const url = request.url();
    if (url.split('#')[0] !== address && !url.startsWith('data:image/')) complaints.push(`request: ${url}`);
  });
  await page.goto(address + hash);
  await page.waitForSelector('html[data-ready]');
  // From the start of the navigation to all of the page but the drawing of figures.
  const ms = await page.evaluate(() => performance.getEntriesByName('ready')[0].startTime);
  return { page, complaints, ms, close: () => context.close() };
}

// Every figure, drawn or failed.
export async function drawn(page) {
  await page.waitForFunction(() =>
    [...document.querySelectorAll('figure[data-state]')].every((figure) => figure.dataset.state !== 'waiting'), null, { timeout: 60000 });
}
