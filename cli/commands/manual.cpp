#include "cli/commands/manual.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "cli/commands/command_form.hpp"
#include "cli/commands/exit_meanings.hpp"
#include "cli/commands/help_text.hpp"
#include "cli/commands/help_topics.hpp"
#include "cli/commands/overview.hpp"
#include "cli/commands/roff.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

/// "import carmen" -> "tcert-import-carmen".
std::string page_name(std::string name) {
  std::ranges::replace(name, ' ', '-');
  return "tcert-" + name;
}

std::string beginning(const std::string& name, int section, std::string_view summary) {
  std::string title = name;
  std::ranges::transform(
      title, title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text(kManualMark);
  text += ".TH \"" + roff_escaped(title) + "\" " + std::to_string(section) + R"( "" "tcert )";
  text += tool_version();
  text += "\" \"tcert manual\"\n.SH NAME\n";
  return text + roff_escaped(name) + " \\- " + roff_escaped(summary) + '\n';
}

/// Upper case are the things to be put in: BUNDLE.
std::string usage_line(const std::string& line) {
  std::string out;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i;
    while (end < line.size() && std::isupper(static_cast<unsigned char>(line[end])) != 0) {
      ++end;
    }
    if (end > i + 1) {
      out += roff_italic(line.substr(i, end - i));
      i = end;
    } else {
      out += roff_escaped(line.substr(i, 1));
      ++i;
    }
  }
  return out + '\n';
}

std::string option_term(const OptionForm& option) {
  std::string term = roff_bold("--" + option.name);
  return option.shown.empty() ? term : term + ' ' + roff_italic(option.shown);
}

std::string option_entry(const OptionForm& option) {
  std::string text = option.text;
  if (!option.usual.empty()) {
    text += " (default: " + option.usual + ")";
  }
  return roff_entry(option_term(option), text);
}

std::string options_section(const CommandForm& form) {
  std::string out = ".SH OPTIONS\n";
  for (std::size_t i = 0; i < form.options.size(); ++i) {
    if (i == form.own && form.own > 0) {
      out += ".SS Common options\n";
    }
    out += option_entry(form.options[i]);
  }
  if (form.takes_parameters) {
    out +=
        roff_paragraph({"Every parameter of tcert-parameters(7) is an option, too: --KEY VALUE."});
  }
  return out;
}

std::string exit_section(const std::vector<TextLines>& own) {
  std::string out = ".SH EXIT STATUS\n";
  for (const TextLines& lines : own) {
    out += roff_paragraph(lines);
  }
  if (!own.empty()) {
    out += roff_paragraph({"Of all commands:"});
  }
  for (const ExitMeaning& one : exit_meanings()) {
    out += roff_entry(roff_bold(one.codes), one.meaning);
  }
  return out;
}

std::string see_also(const std::vector<std::string>& pages) {
  std::string out = ".SH SEE ALSO\n";
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const std::string& page = pages[i];
    const auto parenthesis = page.find('(');
    out += ".BR " + roff_escaped(page.substr(0, parenthesis)) + ' ' + page.substr(parenthesis) +
           (i + 1 < pages.size() ? ",\n" : "\n");
  }
  return out;
}

/// The pages of what a help text speaks of, 'tcert certify', and what belongs to the form.
std::vector<std::string> pages_near(const NamedForm& one, const std::vector<NamedForm>& all) {
  std::set<std::string> near;
  for (const NamedForm& other : all) {
    const std::string word = "tcert " + other.name;
    const bool is_spoken_of = one.form.help.find(word + ' ') != std::string::npos ||
                              one.form.help.find(word + '\'') != std::string::npos;
    const bool is_of_it =
        other.name.starts_with(one.name + ' ') || one.name.starts_with(other.name + ' ');
    if (other.name != one.name && (is_spoken_of || is_of_it)) {
      near.insert(page_name(other.name) + "(1)");
    }
  }
  std::vector<std::string> pages{"tcert(1)"};
  pages.insert(pages.end(), near.begin(), near.end());
  for (const HelpTopic& topic : help_topics()) {
    const std::string name(topic.name);
    const bool is_named = one.form.help.find("help " + name) != std::string::npos;
    if (is_named || (topic.name == "parameters" && one.form.takes_parameters) ||
        (topic.name == "bundle" && one.form.help.find("BUNDLE") != std::string::npos)) {
      pages.push_back(page_name(name) + "(7)");
    }
  }
  return pages;
}

ManualPage page_of(const NamedForm& one, const std::vector<NamedForm>& all) {
  const HelpText help = help_text(one.form.help);
  const std::string name = page_name(one.name);
  std::string text = beginning(name, 1, one.summary) + ".SH SYNOPSIS\n.nf\n";
  for (const std::string& line : help.usage) {
    text += usage_line(line);
  }
  text += ".fi\n.SH DESCRIPTION\n";
  for (const TextLines& lines : help.purpose) {
    text += roff_paragraph(lines);
  }
  text += options_section(one.form) + ".SH EXAMPLE\n" + roff_literal(help.examples) +
          exit_section(help.exits) + ".SH COST\n" + roff_paragraph(help.cost) +
          see_also(pages_near(one, all));
  return {name, 1, std::move(text)};
}

/// All that has a page, for the page of the tool.
std::vector<std::string> all_pages(const std::vector<NamedForm>& all) {
  std::vector<std::string> pages;
  pages.reserve(all.size() + help_topics().size());
  for (const NamedForm& one : all) {
    pages.push_back(page_name(one.name) + "(1)");
  }
  for (const HelpTopic& topic : help_topics()) {
    pages.push_back(page_name(std::string(topic.name)) + "(7)");
  }
  return pages;
}

ManualPage tool_page(const std::vector<NamedForm>& all) {
  std::string text = beginning("tcert", 1, kToolSummary) + ".SH SYNOPSIS\n.nf\n" +
                     usage_line("tcert COMMAND [options]") + ".fi\n.SH DESCRIPTION\n" +
                     roff_paragraph({std::string(kToolPurpose)}) + ".SS Commands\n";
  for (const NamedForm& one : all) {
    text += roff_entry(roff_bold(one.name), one.summary);
  }
  text += ".SH OPTIONS\n";
  text += roff_entry(roff_bold("--help"), "the commands; after a command, what it does and takes");
  text += roff_entry(roff_bold("--version") + ", " + roff_bold("-V"), "of this build");
  text += ".SH EXAMPLE\n" + roff_literal({std::string(kToolExample)}) + exit_section({}) +
          see_also(all_pages(all));
  return {"tcert", 1, std::move(text)};
}

const std::string& words_of_cell(const TableCell& cell) { return std::get<std::string>(cell); }

/// A row: its name and unit, then what the columns between say, then its text.
std::string topic_entry(const Table& table, const std::vector<TableCell>& row, std::size_t name) {
  std::string term = roff_bold(words_of_cell(row[name]));
  std::string between;
  for (std::size_t c = name + 1; c + 1 < row.size(); ++c) {
    const std::string& cell = words_of_cell(row[c]);
    if (table.columns[c].name == "unit") {
      term += cell.empty() ? "" : " [" + roff_escaped(cell) + "]";
    } else if (!cell.empty()) {
      // "required" says by itself what it is, a default or a bound does not.
      const bool has_heading = table.columns[c].name != "needed";
      between += between.empty() ? " (" : "; ";
      between += (has_heading ? table.columns[c].heading + ": " : "") + cell;
    }
  }
  return roff_entry(term, words_of_cell(row.back()) + (between.empty() ? "" : between + ")"));
}

ManualPage page_of(const HelpTopic& topic) {
  const std::string name = page_name(std::string(topic.name));
  const Table table = topic.table();
  std::string text =
      beginning(name, 7, topic.summary) + ".SH DESCRIPTION\n" + roff_paragraph({table.title + "."});
  // Rows of one file stand together, under its name.
  const bool has_files = table.columns.front().name == "file";
  std::string file;
  for (const std::vector<TableCell>& row : table.rows) {
    if (has_files && words_of_cell(row.front()) != file) {
      file = words_of_cell(row.front());
      text += ".SS \"" + roff_escaped(file) + "\"\n";
    }
    text += topic_entry(table, row, has_files ? 1 : 0);
  }
  text += ".SH NOTES\n";
  for (const std::string& note : table.footnotes) {
    text += roff_paragraph({note});
  }
  return {name, 7, text + see_also({"tcert(1)", "tcert-help(1)"})};
}

}  // namespace

std::string ManualPage::path() const {
  return "man" + std::to_string(section) + '/' + name + '.' + std::to_string(section);
}

std::vector<ManualPage> manual() {
  const std::vector<NamedForm> all = all_forms();
  std::vector<ManualPage> pages{tool_page(all)};
  for (const NamedForm& one : all) {
    pages.push_back(page_of(one, all));
  }
  for (const HelpTopic& topic : help_topics()) {
    pages.push_back(page_of(topic));
  }
  return pages;
}

}  // namespace tcert::cli
