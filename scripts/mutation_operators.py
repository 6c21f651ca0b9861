"""Single changes of C++ text that a test ought to notice: each a place and what stands there instead."""
import re
from typing import NamedTuple


class Mutant(NamedTuple):
    file: str
    operator: str
    begin: int  # offsets into the file's text
    end: int
    text: str  # in the place of what was there

    def of(self, source):
        return source[:self.begin] + self.text + source[self.end:]

    def line(self, source):
        return source.count("\n", 0, self.begin) + 1


def both_ways(pairs):
    return pairs | {b: a for a, b in pairs.items()}


BOUNDARY = both_ways({"<": "<=", ">": ">="})
NEGATED = both_ways({"<": ">=", ">": "<=", "==": "!="})
ARITHMETIC = both_ways({"+": "-", "*": "/", "+=": "-=", "*=": "/="}) | {"%": "*"}
LOGICAL = both_ways({"&&": "||", "|": "&", "<<": ">>"}) | {"|=": "&=", "^": "|", "^=": "&="}
EXTREMES = both_ways({"std::min": "std::max", "std::fmin": "std::fmax", "std::floor": "std::ceil", "std::any_of": "std::all_of",
                      "std::lower_bound": "std::upper_bound", "std::min_element": "std::max_element"})
TWINS = both_ways({".x_m": ".y_m", "Side::back": "Side::front", "left_m": "right_m", "ends[0]": "ends[1]", ".low": ".high"})

NUMBER = re.compile(r"(?<![\w.'])(\d+\.\d+(?:e-?\d+)?|\d+e-?\d+|\d+)(U?)(?![\w.'])")
OPERATION = re.compile(r"(?<=[\w)\]] )([-+*/%<>=!&|^]{1,3})(?=[ \n])")
STATEMENT = re.compile(r"^ +(?:[\w.\[\]()>*:-]+ [-+*/|&^]?= [^;{}]*|[\w.>:-]+\([^;{}]*\)|\+\+\w+|--\w+|break|continue);$", re.M)
NO_STATEMENT = ("return", "throw", "delete", "using", "static_assert", "assert")


def blanked(text):
    """The text with comments, literals of text, directives and declarations blanked, every offset kept."""
    blank = lambda m: re.sub(r"[^\n]", " ", m.group())
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\d)\'(?:\\.|[^\'\\])\'|^[ ]*#[^\n]*', blank, text, flags=re.S | re.M)
    return re.sub(r"^ *(?:static_assert|assert|template|using|namespace|class|struct|case)\b[^\n]*", blank, text, flags=re.M)


def closing(text, start):
    """Offset of the parenthesis that closes the one at `start`; -1 if there is none."""
    depth = 0
    for at in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return -1


def operations(code):
    for m in OPERATION.finditer(code):
        for name, table in (("boundary", BOUNDARY), ("negated", NEGATED), ("arithmetic", ARITHMETIC), ("logical", LOGICAL)):
            if m.group(1) in table:
                yield name, m.start(1), m.end(1), table[m.group(1)]


def constants(code):
    for m in NUMBER.finditer(code):
        digits, suffix = m.groups()
        if digits.isdigit():
            yield "constant", *m.span(), f"{int(digits) + 1}{suffix}"
        else:
            yield "constant", *m.span(), repr(2 * float(digits)) if float(digits) else "1.0"


def names(code):
    for m in re.finditer(r"std::\w+(?=[(<])", code):
        if m.group() in EXTREMES:
            yield "extreme", *m.span(), EXTREMES[m.group()]
    for twin, other in TWINS.items():
        for m in re.finditer((r"" if twin[0] == "." else r"(?<!\w)") + re.escape(twin) + r"(?!\w)", code):
            yield "twin", *m.span(), other


def conditions(code, text):
    for m in re.finditer(r"\b(if|while) \(", code):
        end = closing(code, m.end() - 1)
        condition = text[m.end():end]
        if end < 0 or ";" in condition or re.match(r"(const )?auto", condition):
            continue
        if m.group(1) == "if":
            yield "condition", m.end(), end, f"!({condition})"
        yield "condition", m.end(), end, "false"
    for m in re.finditer(r"(?<!\w)!(?=[\w(])", code):
        yield "condition", *m.span(), ""
    for m in re.finditer(r"\? ([\w.()*\[\]:-]+) : ([\w.()*\[\]-]+)(?=[;,)])", code):
        yield "condition", *m.span(), f"? {m.group(2)} : {m.group(1)}"


def statements(code):
    for m in STATEMENT.finditer(code):
        if not m.group().lstrip().startswith(NO_STATEMENT):
            yield "removed", *m.span(), ";" + "\n" * m.group().count("\n")


def values(code, text):
    for m in re.finditer(r"\breturn ([^;{}]+);", code):
        value = text[slice(*m.span(1))]
        flipped = {"true": "false", "false": "true"}.get(value)
        yield "returned", *m.span(1), flipped or "{}"
        if not flipped and not re.search(r"^(\*|k[A-Z]|TCERT|std::nullopt)| [<>=!]=? | (&&|\|\|) ", value):
            yield "sign", *m.span(1), f"-({value})"
    for m in re.finditer(r"(?<=[(=,:?{] )-(?=[\w(])|(?<=\()-(?=[\w(])", code):
        yield "sign", *m.span(), ""
    for m in re.finditer(r"double \w+ =\s+([^;{}]+);", code):
        yield "sign", *m.span(1), f"-({text[slice(*m.span(1))]})"


def mutants_of(file, text):
    """Every mutant of a file, in order, none twice."""
    code = blanked(text)
    found = (*operations(code), *constants(code), *names(code), *conditions(code, text), *statements(code), *values(code, text))
    return [Mutant(file, *m) for m in sorted(set(found), key=lambda m: (m[1], m[2], m[3], m[0]))]
