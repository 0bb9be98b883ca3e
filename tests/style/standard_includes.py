#!/usr/bin/env python3
"""Each file includes the standard headers whose names it uses.

One standard library lets a name through by a header that another does not include there: what
builds with one compiler fails with the next. What a file reaches through headers of the project
counts: they promise the same everywhere.
    standard_includes.py FILE...      prints file:line: name, header; exit 1 if there is any
"""
import functools
import pathlib
import re
import sys

# Names of namespace std, and macros, by the header that C++20 promises them in.
HEADERS = {
    "algorithm":
        "adjacent_find all_of any_of binary_search clamp copy copy_if copy_n count count_if "
        "equal equal_range fill fill_n find find_if find_if_not for_each generate includes "
        "inplace_merge is_sorted lexicographical_compare lower_bound max max_element merge min "
        "min_element minmax minmax_element mismatch none_of nth_element partial_sort partition "
        "remove_if replace replace_if reverse rotate search set_difference set_intersection "
        "set_union shuffle sort stable_sort transform unique upper_bound",
    "array": "array",
    "atomic":
        "atomic atomic_flag memory_order_acquire memory_order_relaxed memory_order_release",
    "bit": "bit_cast bit_width countl_zero countr_zero endian has_single_bit popcount rotl rotr",
    "cctype": "isalnum isalpha isdigit isprint isspace isxdigit tolower toupper",
    "cerrno": "errno",
    "charconv": "chars_format from_chars from_chars_result to_chars",
    "chrono": "chrono",
    "climits": "CHAR_BIT INT_MAX INT_MIN LLONG_MAX LONG_MAX PATH_MAX UINT_MAX",
    "cmath":
        "abs acos asin atan atan2 cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 fabs "
        "floor fma fmod frexp hypot isfinite isinf isnan ldexp lerp lgamma llround log log10 "
        "log1p log2 lrint lround modf nearbyint nextafter pow remainder rint round signbit sin "
        "sinh sqrt tan tanh tgamma trunc",
    "compare": "partial_ordering strong_ordering weak_ordering",
    "condition_variable": "condition_variable",
    "csignal": "raise sig_atomic_t signal",
    "cstddef": "byte nullptr_t ptrdiff_t size_t to_integer",
    "cstdint":
        "INT32_MAX INT64_MAX UINT32_MAX UINT64_MAX int16_t int32_t int64_t int8_t intptr_t "
        "uint16_t uint32_t uint64_t uint8_t uintptr_t",
    "cstdio":
        "FILE fclose fflush fopen fprintf fread fwrite perror printf remove rename snprintf",
    "cstdlib":
        "EXIT_FAILURE EXIT_SUCCESS _Exit abort exit free getenv malloc strtod strtol system",
    "cstring": "memchr memcmp memcpy memmove memset strchr strcmp strerror strlen",
    "ctime": "gmtime localtime mktime strftime time_t tm",
    "deque": "deque",
    "exception":
        "current_exception exception exception_ptr rethrow_exception terminate "
        "uncaught_exceptions",
    "filesystem": "filesystem",
    "fstream": "fstream ifstream ofstream",
    "functional":
        "bind cref function greater hash invoke less minus multiplies plus ref "
        "reference_wrapper",
    "future": "async future launch packaged_task promise",
    "initializer_list": "initializer_list",
    "iomanip": "setfill setprecision setw",
    "iostream": "cerr cin clog cout",
    "istream": "istream",
    "iterator":
        "advance back_inserter begin data distance end inserter istreambuf_iterator "
        "iterator_traits make_move_iterator next prev rbegin rend size ssize",
    "limits": "numeric_limits",
    "list": "list",
    "locale": "locale",
    "map": "map multimap",
    "memory": "addressof allocator make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "mutex": "call_once lock_guard mutex once_flag scoped_lock unique_lock",
    "new": "bad_alloc launder nothrow",
    "numbers": "numbers",
    "numeric":
        "accumulate adjacent_difference exclusive_scan gcd inclusive_scan inner_product iota "
        "lcm midpoint partial_sum reduce transform_reduce",
    "optional": "bad_optional_access make_optional nullopt nullopt_t optional",
    "ostream": "endl flush ostream",
    "queue": "priority_queue queue",
    "random":
        "mt19937 mt19937_64 normal_distribution random_device uniform_int_distribution "
        "uniform_real_distribution",
    "ranges": "views",
    "regex": "cmatch regex regex_match regex_replace regex_search smatch sregex_iterator",
    "set": "multiset set",
    "span": "as_bytes as_writable_bytes dynamic_extent span",
    "sstream": "istringstream ostringstream stringstream",
    "stack": "stack",
    "stdexcept":
        "domain_error invalid_argument length_error logic_error out_of_range overflow_error "
        "range_error runtime_error",
    "string": "char_traits getline stod stoi stol stoul stoull string to_string u32string",
    "string_view": "string_view",
    "system_error":
        "errc error_code generic_category make_error_code system_category system_error",
    "thread": "jthread this_thread thread",
    "tuple": "apply forward_as_tuple make_tuple tie tuple",
    "type_traits":
        "conditional_t decay_t enable_if_t invoke_result_t is_arithmetic_v is_base_of_v "
        "is_convertible_v is_enum_v is_floating_point_v is_integral_v is_same_v is_signed_v "
        "is_trivially_copyable_v make_signed_t make_unsigned_t remove_cvref_t underlying_type_t",
    "unordered_map": "unordered_map unordered_multimap",
    "unordered_set": "unordered_set",
    "utility":
        "as_const cmp_less declval exchange forward in_place index_sequence make_index_sequence "
        "make_pair move pair swap",
    "variant": "get_if holds_alternative monostate variant visit",
    "vector": "vector",
}
# A range's or a stream's own header promises these too.
RANGES = {"array", "map", "set", "span", "string", "string_view", "vector"}
STREAMS = {"fstream", "iostream", "sstream"}
# Other headers that promise a name.
ALSO = {
    "abs": {"cstdlib"},
    "begin": RANGES,
    "data": RANGES,
    "declval": {"type_traits"},
    "end": RANGES,
    "endl": STREAMS,
    "errc": {"charconv"},
    "error_code": {"filesystem"},
    "exception": {"stdexcept"},
    "flush": STREAMS,
    "getline": STREAMS | {"istream"},
    "hash": {"memory", "optional", "string", "string_view", "variant"},
    "initializer_list": RANGES | {"algorithm", "utility"},
    "istream": STREAMS,
    "move": {"algorithm"},
    "ostream": STREAMS,
    "pair": {"algorithm", "map", "tuple", "unordered_map"},
    "rbegin": RANGES,
    "remove": {"algorithm"},
    "rend": RANGES,
    "size": RANGES,
    "size_t": {"cstdint", "cstdio", "cstdlib", "cstring", "ctime"},
    "ssize": RANGES,
    "string": {"sstream"},
    "swap": {"algorithm"},
    "time_t": {"chrono"},
}
ROOTS = [pathlib.Path(root) for root in (".", "src", "tests")]
HOME = {name: header for header, names in HEADERS.items() for name in names.split()}
MACROS = [name for name in HOME if name.isupper() and name != "FILE"] + ["errno"]
USE = re.compile(r"std::(?:ranges::)?([a-z_][a-z0-9_]*)|(?<![\w:])(" + "|".join(MACROS) + r")\b")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
NOISE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'""", re.S
)


def without_comments_and_texts(text):
    return NOISE.sub(lambda m: "\n" * m.group().count("\n"), text)


@functools.cache
def reached(path):
    """The headers that a file names, and those that headers of the project name for it."""
    names = set()
    open_files, seen = [path], {path}
    while open_files:
        for include in INCLUDE.findall(open_files.pop().read_text(encoding="utf-8")):
            names.add(include)
            for root in ROOTS:
                header = root / include
                if header not in seen and header.is_file():
                    seen.add(header)
                    open_files.append(header)
    return names


def missing(path):
    text = path.read_text(encoding="utf-8")
    have = reached(path)
    found = {}
    for number, line in enumerate(without_comments_and_texts(text).split("\n"), 1):
        for use in USE.finditer(line):
            name = use.group(1) or use.group(2)
            home = HOME.get(name)
            if home is not None and not ({home} | ALSO.get(name, set())) & have:
                found.setdefault(home, (number, use.group()))
    return [(number, name, header) for header, (number, name) in sorted(found.items())]


def main():
    count = 0
    for name in sys.argv[1:]:
        for number, use, header in missing(pathlib.Path(name)):
            print(f"{name}:{number}: {use} needs #include <{header}>")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
