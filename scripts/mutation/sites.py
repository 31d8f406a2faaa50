"""Finds the places of C++ sources that can be mutated, on the abstract syntax tree of clang.

A site is one place, with one or two mutants, and the edits that make them switchable. The word NUMBER in an edit stands
for the number of the site's first mutant. schemata.hpp defines the functions that the edits call.
"""
import dataclasses
import re

from clang.cindex import Config, CursorKind as Kind, Index, TypeKind

NAMESPACE = "::pardel_mutation::"
# Name of the operator in clang: its text, the function that mutates it, and the descriptions of its mutants.
COMPARISONS = {
    "LT": ("<", "less", ["< becomes <=", "< is negated"]),
    "LE": ("<=", "less_equal", ["<= becomes <", "<= is negated"]),
    "GT": (">", "greater", ["> becomes >=", "> is negated"]),
    "GE": (">=", "greater_equal", [">= becomes >", ">= is negated"]),
}
OPERATORS = {
    "Add": ("+", "plus", ["+ becomes -"]),
    "Sub": ("-", "minus", ["- becomes +"]),
    "Mul": ("*", "times", ["* becomes +"]),
    "Div": ("/", "divided", ["/ becomes *"]),
    "Rem": ("%", "modulo", ["% becomes /"]),
    "AddAssign": ("+=", "add", ["+= becomes -="]),
    "SubAssign": ("-=", "subtract", ["-= becomes +="]),
}
EQUALITIES = {"EQ": "==", "NE": "!="}
LOGICAL = {"LAnd": ("&&", "or_true"), "LOr": ("||", "and_false")}

FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.FUNCTION_TEMPLATE, Kind.CONSTRUCTOR, Kind.CONVERSION_FUNCTION}
CONDITIONS = {Kind.IF_STMT, Kind.WHILE_STMT, Kind.CONDITIONAL_OPERATOR, Kind.FOR_STMT}
# Evaluated by the compiler, or not at all.
NOT_AT_RUN_TIME = {Kind.STATIC_ASSERT, Kind.CXX_UNARY_EXPR, Kind.TYPE_REF, Kind.TEMPLATE_REF, Kind.CONCEPT_DECL,
                   Kind.REQUIRES_EXPR, Kind.ENUM_CONSTANT_DECL, Kind.TYPE_ALIAS_DECL, Kind.TYPEDEF_DECL}
NAMES = {Kind.DECL_REF_EXPR, Kind.MEMBER_REF_EXPR}
JUMPS = {Kind.CONTINUE_STMT: "continue", Kind.BREAK_STMT: "break"}
EXPRESSIONS = {Kind.CALL_EXPR, Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.UNARY_OPERATOR}
LITERALS = {Kind.INTEGER_LITERAL: "the constant becomes the next one", Kind.FLOATING_LITERAL: "the constant is doubled",
            Kind.CXX_BOOL_LITERAL_EXPR: "the truth value is negated"}


@dataclasses.dataclass
class Edit:
    """Texts around a range of bytes. Of the edits of one range, those with the smaller `depth` are the outer ones."""
    start: int
    end: int
    prefix: str
    suffix: str
    depth: int = 0
    operator: tuple = ()  # (offset, length) of the operator, which a comma replaces


@dataclasses.dataclass
class Site:
    file: str
    line: int
    function: str
    edits: list
    mutants: list  # a description of each

    def key(self):
        return self.file, *((e.start, e.end, e.depth, e.prefix) for e in self.edits)


def bare(cursor):
    """The expression without implicit conversions and temporaries."""
    while cursor.kind == Kind.UNEXPOSED_EXPR:
        children = list(cursor.get_children())
        if len(children) != 1 or extent(children[0]) != extent(cursor):
            break
        cursor = children[0]
    return cursor


def extent(cursor):
    return cursor.extent.start.offset, cursor.extent.end.offset


def operator_of(cursor):
    """The name of a built-in operator: "LT" for <."""
    if cursor.kind not in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR):
        return ""
    return cursor.binary_operator.name


def is_bool(cursor):
    return cursor.type.get_canonical().kind == TypeKind.BOOL


def may_be_bool(cursor):
    """True for a truth value, and in a template for an expression whose type is not known."""
    return is_bool(cursor) or cursor.type.kind in (TypeKind.DEPENDENT, TypeKind.UNEXPOSED)


class Finder:
    """Finds the sites of one file, in the syntax tree of a source that contains or includes it."""

    def __init__(self, file, name):
        self.text = file.read_bytes()
        self.file = name
        self.sites = []
        self.function = ""

    def add(self, line, mutants, *edits):
        self.sites.append(Site(self.file, line, self.function, list(edits), mutants))

    def wrap(self, cursor, function, mutants, operator=(), depth=0):
        edit = Edit(*extent(cursor), f"{NAMESPACE}{function}<NUMBER>(", ")", depth, operator)
        self.add(cursor.extent.start.line, mutants, edit)

    def snippet(self, cursor):
        start, end = extent(cursor)
        return self.text[start:end].decode()

    def operator_position(self, cursor, sides, text):
        """(offset, length) of the operator between two operands; nothing if other text stands there."""
        start, end = extent(sides[0])[1], extent(sides[1])[0]
        between = self.text[start:end].decode()
        if between.strip() != text:
            return ()
        return start + between.index(text), len(text)

    def visit_file(self, cursor):
        """Visits the declarations of a namespace or a class."""
        if cursor.kind in FUNCTIONS:
            self.visit_function(cursor)
        elif cursor.kind in (Kind.NAMESPACE, Kind.STRUCT_DECL, Kind.CLASS_DECL, Kind.CLASS_TEMPLATE,
                             Kind.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION, Kind.FRIEND_DECL, Kind.LINKAGE_SPEC):
            for child in cursor.get_children():
                self.visit_file(child)

    def visit_function(self, cursor):
        self.function = cursor.spelling
        for child in cursor.get_children():
            if child.kind == Kind.COMPOUND_STMT:
                self.early_return(cursor, child)
                self.visit(child, cursor)

    def early_return(self, function, body):
        """The function returns at once. Functions of one statement have other mutants."""
        if len(list(body.get_children())) < 2 or function.kind == Kind.CONSTRUCTOR:
            return
        result = function.result_type.get_canonical()
        if result.kind in (TypeKind.LVALUEREFERENCE, TypeKind.AUTO):
            return
        value = "" if result.kind == TypeKind.VOID else " {}"
        start = extent(body)[0] + 1
        self.add(body.extent.start.line, ["the function returns at once"],
                 Edit(start, start, f"if ({NAMESPACE}active(NUMBER)) return{value};", ""))

    def visit(self, cursor, parent):
        if cursor.kind in NOT_AT_RUN_TIME or self.is_constant(cursor) or self.is_template_argument(cursor):
            return
        if self.is_only_typed(cursor):
            return
        children = list(cursor.get_children())
        self.statements(cursor, children)
        self.condition(cursor, children)
        self.expression(cursor, children, parent)
        for child in children:
            self.visit(child, cursor)

    def is_constant(self, cursor):
        """True for a variable that the compiler may compute, and for if constexpr."""
        text = self.text[slice(*extent(cursor))].lstrip()
        if cursor.kind == Kind.IF_STMT and text[2:].lstrip().startswith(b"constexpr"):
            return True
        if cursor.kind != Kind.VAR_DECL:
            return False
        literal = [c for c in cursor.walk_preorder() if c.kind in NAMES or c.kind == Kind.CALL_EXPR] == []
        return b"constexpr" in text.split(b"=")[0] or (cursor.type.is_const_qualified() and literal)

    def is_template_argument(self, cursor):
        """True for an argument of a template. The style has no space before the bracket, unlike before <."""
        return re.search(rb"\w<([^<>(){};=]*,\s*)?$", self.line_before(extent(cursor)[0])) is not None

    def line_before(self, position):
        return self.text[:position].rpartition(b"\n")[2]

    def is_only_typed(self, cursor):
        """True inside decltype, which needs no value."""
        return re.search(rb"\bdecltype\([^;]*$", self.line_before(extent(cursor)[0])) is not None

    def statements(self, cursor, children):
        """Statements that are left out."""
        if cursor.kind == Kind.COMPOUND_STMT:
            branches = children
        elif cursor.kind == Kind.IF_STMT:
            branches = children[1:]
        elif cursor.kind in (Kind.FOR_STMT, Kind.WHILE_STMT, Kind.CXX_FOR_RANGE_STMT):
            branches = children[-1:]
        else:
            return
        for statement in branches:
            kind = bare(statement).kind
            if kind == Kind.UNEXPOSED_EXPR:
                kind = bare(next(statement.get_children(), statement)).kind
            jump = JUMPS.get(kind) or ("return" if self.is_plain_return(statement) else "")
            if (kind in EXPRESSIONS or jump) and self.is_statement(statement):
                self.add(statement.extent.start.line, [f"{jump or 'the statement'} is left out"],
                         Edit(*extent(statement), f"if ({NAMESPACE}active(NUMBER)) {{}} else ", "", depth=-2))

    def is_statement(self, cursor):
        """True if the text before and after the expression is that of a statement, not that of a condition."""
        start, end = extent(cursor)
        before, after = self.text[:start].rstrip(), self.text[end:].lstrip()
        return after.startswith(b";") and before.endswith((b"{", b"}", b";", b")", b"else", b"do", b"\n"))

    @staticmethod
    def is_plain_return(statement):
        return statement.kind == Kind.RETURN_STMT and not list(statement.get_children())

    def condition(self, cursor, children):
        """Conditions that are negated, if they have no operators, which have mutants of their own."""
        if cursor.kind in CONDITIONS and children:
            candidates = children[:3] if cursor.kind == Kind.FOR_STMT else children[:1]
        elif cursor.kind == Kind.RETURN_STMT and children:
            candidates = children[:1]
        else:
            return
        for candidate in candidates:
            inner = bare(candidate)
            if is_bool(inner) and inner.kind in (Kind.CALL_EXPR, *NAMES) and not candidate.kind.is_declaration():
                self.wrap(candidate, "negated", ["the condition is negated"])

    def expression(self, cursor, children, parent):
        name = operator_of(cursor)
        if name in COMPARISONS or name in OPERATORS or name in EQUALITIES or name in LOGICAL:
            self.binary(cursor, children, name)
        elif cursor.kind == Kind.UNARY_OPERATOR and cursor.type.get_canonical().kind != TypeKind.VECTOR:
            self.unary(cursor)
        elif cursor.kind in LITERALS:
            self.literal(cursor, parent)
        elif cursor.kind == Kind.CALL_EXPR:
            self.arguments(list(cursor.get_arguments()))
        elif cursor.kind == Kind.INIT_LIST_EXPR:
            self.arguments(children)

    def binary(self, cursor, children, name):
        if name in EQUALITIES:
            self.wrap(cursor, "negated", [f"{EQUALITIES[name]} is negated"])
            return
        if name in LOGICAL:
            text, function = LOGICAL[name]
            for side, which in zip(children, ("left", "right")):
                if may_be_bool(bare(side)):
                    self.wrap(side, function, [f"the {which} operand of {text} is left out"], depth=-1)
            return
        kind = cursor.type.get_canonical()
        if kind.kind == TypeKind.VECTOR or "basic_string" in kind.spelling or self.has_text(cursor):
            return
        text, function, mutants = (COMPARISONS | OPERATORS)[name]
        operator = self.operator_position(cursor, children, text)
        if operator:
            self.wrap(cursor, function, mutants, operator)

    @staticmethod
    def has_text(cursor):
        """True for an expression with a text, which has no other operator."""
        return any(part.kind == Kind.STRING_LITERAL for part in cursor.walk_preorder())

    def unary(self, cursor):
        text = self.snippet(cursor)
        if text.startswith("!"):
            self.wrap(cursor, "negated", ["! is left out"])
        elif text.startswith("-") and not text.startswith("--"):
            self.wrap(cursor, "without_sign", ["the sign is left out"])

    def literal(self, cursor, parent):
        if parent.kind in NAMES or parent.kind in (Kind.CASE_STMT, Kind.OVERLOADED_DECL_REF, Kind.MEMBER_REF):
            return  # a template argument
        if parent.kind == Kind.VAR_DECL and cursor.extent.start.offset < parent.location.offset:
            return  # of the type of the variable
        if self.snippet(cursor) and cursor.extent.start.file.name == cursor.extent.end.file.name:
            self.wrap(cursor, "constant", [LITERALS[cursor.kind]])

    def arguments(self, arguments):
        """Two neighbouring arguments of one type that are swapped. Arguments are names, so that nothing runs twice."""
        if arguments and self.is_symmetric(arguments[0]):
            return
        for a, b in zip(arguments, arguments[1:]):
            if not (self.is_name(a) and self.is_name(b)) or self.snippet(a) == self.snippet(b):
                continue
            if bare(a).type.get_canonical().spelling != bare(b).type.get_canonical().spelling:
                continue
            first, second = self.snippet(a), self.snippet(b)
            self.add(a.extent.start.line, [f"{first} and {second} are swapped"],
                     Edit(*extent(a), f"{NAMESPACE}pick<NUMBER>(", f", {second})", depth=1),
                     Edit(*extent(b), f"{NAMESPACE}pick<NUMBER>(", f", {first})", depth=1))

    def is_symmetric(self, first):
        """True for the first argument of a function of which the order of the arguments does not matter."""
        return re.search(rb"\b(min|max|minmax)\(\{?$", self.line_before(extent(first)[0])) is not None

    def is_name(self, cursor):
        inner = bare(cursor)
        return inner.kind in NAMES and all(bare(c).kind in NAMES or c.kind in (Kind.NAMESPACE_REF, Kind.TYPE_REF)
                                           for c in inner.walk_preorder()) and "(" not in self.snippet(cursor)


def find_sites(source, arguments, root, folders):
    """The sites of the files below the folders that a source contains or includes: {file: [Site]}."""
    if not Config.loaded:
        Config.set_library_file("libclang-19.so.1")
    unit = Index.create().parse(str(source), args=arguments)
    errors = [d for d in unit.diagnostics if d.severity >= 3]
    if errors:
        raise RuntimeError(f"clang cannot parse {source}: {errors[0]}")
    finders = {}
    for cursor in unit.cursor.get_children():
        if cursor.location.file is None:
            continue
        path = (root / cursor.location.file.name).resolve()
        if not any(path.is_relative_to(root / folder) for folder in folders):
            continue
        name = str(path.relative_to(root))
        finder = finders.setdefault(name, Finder(path, name))
        finder.visit_file(cursor)
    return {name: finder.sites for name, finder in finders.items()}
