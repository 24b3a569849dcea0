"""One PTX instruction as C++ (PTX ISA 9.0, chapter Instruction Set; operations in ptxOperations.h).

Registers are unsigned integers of their width, predicates bool; a number is what its bits say where an
instruction asks for a number. Whatever is not written here is an Unknown."""

import re

SHARED = "_ZN3fpm12blockScratchE"
FUSED = "fusedTold"  # of each fused multiply-add, see ptxOperations.h
WIDTH = {"rs": 16, "r": 32, "f": 32, "fd": 64, "rd": 64, "p": 1}
SPECIAL = {"%tid.x": "threadIdx.x", "%ntid.x": "blockDim.x", "%ctaid.x": "blockIdx.x",
           "%nctaid.x": "gridDim.x"}
TYPE = {"s16": "int16_t", "u16": "uint16_t", "b16": "uint16_t", "s32": "int32_t", "u32": "uint32_t",
        "b32": "uint32_t", "s64": "int64_t", "u64": "uint64_t", "b64": "uint64_t", "u8": "uint8_t",
        "s8": "int8_t", "b8": "uint8_t", "f32": "float", "f64": "double"}
BYTES = {name: int(name[1:]) // 8 for name in TYPE}
COMPARE = {"eq": "==", "ne": "!=", "lt": "<", "le": "<=", "gt": ">", "ge": ">="}
UNORDERED = {"ltu": ">=", "leu": ">", "gtu": "<=", "geu": "<", "neu": "=="}
ARITHMETIC = {"add": "+", "sub": "-", "mul": "*", "div": "/", "rem": "%"}
BITWISE = {"and": "&", "or": "|", "xor": "^"}
SPACES = ("param", "global", "shared", "local")


class Unknown(Exception):
    pass


def register(operand):
    """Name and width, or None."""
    match = re.fullmatch(r"%(rs|rd|fd|r|f|p)(\d+)", operand)
    if match:
        return match.group(1) + match.group(2), WIDTH[match.group(1)]
    return (operand[1:], 64) if operand in ("%SP", "%SPL") else None


def isFloat(kind):
    return kind[0] == "f"


def label(name):
    return name.replace("$", "_")


def splitOperands(text):
    """At commas outside of brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "{[") - (letter in "}]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def put(target, kind, expression):
    """Assigns an expression of a type to a register, extended to its width by the type's sign."""
    name, width = register(target)
    if kind == "f64":
        return f"{name} = U64({expression});"
    if kind == "f32":
        return f"{name} = U32({expression});"
    if kind == "pred":
        return f"{name} = {expression};"
    narrowed = kind[0] == "s" or BYTES[kind] * 8 != width
    return f"{name} = (uint{width}_t)" + (f"({TYPE[kind]})" if narrowed else "") + f"({expression});"


class Instructions:
    """Those of one function: `parameters` are its own names in order, `callee` names a function,
    `nextFused` numbers the fused multiply-adds of all functions."""

    def __init__(self, parameters, callee, nextFused):
        self.parameters = {name: place for place, name in enumerate(parameters)}
        self.callee = callee
        self.nextFused = nextFused

    # Operands

    def symbol(self, operand):
        if operand == SHARED:
            return "0"
        if operand in self.parameters:
            return f"(uint64_t)P_{self.parameters[operand]}"
        if operand.startswith("__local_depot"):
            return "(uint64_t)depot"
        if re.fullmatch(r"param\d+", operand):
            return f"(uint64_t){operand}"
        raise Unknown(f"symbol {operand}")

    @staticmethod
    def floatBits(operand):
        """Of a constant as PTX writes numbers: 0d or 0f and their bits; None: no such constant."""
        match = re.fullmatch(r"0([dDfF])([0-9a-fA-F]+)", operand)
        if not match:
            return None
        return f"0x{match.group(2)}" + ("ull" if match.group(1) in "dD" else "u")

    def value(self, operand, kind):
        """As an expression of that type."""
        known = register(operand)
        if known:
            return {"pred": known[0], "f64": f"D({known[0]})",
                    "f32": f"F({known[0]})"}.get(kind) or f"({TYPE[kind]}){known[0]}"
        if operand in SPECIAL:
            return f"({TYPE[kind]}){SPECIAL[operand]}"
        bits = self.floatBits(operand)
        if bits:
            return ("D" if bits.endswith("ull") else "F") + f"({bits})"
        if re.fullmatch(r"-?(\d+|0x[0-9a-fA-F]+)", operand):
            number = int(operand, 0)
            if kind == "pred":
                return "true" if number else "false"
            if isFloat(kind):
                raise Unknown(f"integer {operand} as a number")
            return f"({TYPE[kind]})0x{number & ((1 << 8 * BYTES[kind]) - 1):x}ull"
        return f"({TYPE[kind]})" + self.symbol(operand)

    def raw(self, operand, width):
        """Its bits."""
        known = register(operand)
        if known:
            return known[0]
        return (self.floatBits(operand)
                or self.value(operand, {16: "b16", 32: "b32", 64: "b64", 1: "pred"}[width]))

    def address(self, operand, space):
        base, offset = re.fullmatch(r"\[([%\w$.]+)(?:\+(-?\d+))?\]", operand).groups()
        offset, known = int(offset or 0), register(base)
        if space == "shared":
            at = known[0] if known else self.symbol(base)
            sign = "(int64_t)(int32_t)" if known and known[1] == 32 else "(int64_t)"
            return f"SHARED({sign}({at}) + {offset})"
        return f"({known[0] if known else self.symbol(base)} + (int64_t){offset})"

    # Instructions, by the first word of their names

    def translate(self, statement):
        guard = re.match(r"@(!?)%p(\d+)\s+", statement)
        words, operands = re.fullmatch(r"(\S+)\s*(.*);",
                                       statement[guard.end():] if guard else statement).groups()
        words = words.split(".")
        method = getattr(self, "op_" + words[0], None)
        if method is None:
            raise Unknown(statement)
        done = method(words, operands if words[0] == "call" else splitOperands(operands))
        if done is None:
            raise Unknown(statement)
        return f"  if ({guard.group(1)}p{guard.group(2)}) {{ {done} }}" if guard else "  " + done

    def op_bra(self, words, a):
        return f"goto {label(a[0])};"

    def op_ret(self, words, a):
        return "return;"

    op_exit = op_ret

    def op_bar(self, words, a):
        return "__syncthreads();" if a == ["0"] else None

    def op_call(self, words, text):
        match = re.fullmatch(r"([\w$]+),\s*\(\s*(.*?)\s*\)", text)
        return f"{self.callee(match.group(1))}({match.group(2)});" if match else None

    def op_mov(self, words, a):
        kind = words[-1]
        if a[0].startswith("{"):
            low, high = (register(part.strip()) for part in a[0][1:-1].split(","))
            return (f"{{ uint64_t t_ = {self.raw(a[1], 64)}; {low[0]} = (uint{low[1]}_t)t_; "
                    f"{high[0]} = (uint{low[1]}_t)(t_ >> {low[1]}); }}")
        name, width = register(a[0])
        if a[1].startswith("{"):
            low, high = (register(part.strip()) for part in a[1][1:-1].split(","))
            return f"{name} = (uint{width}_t){low[0]} | ((uint{width}_t){high[0]} << {low[1]});"
        if kind == "pred":
            return put(a[0], kind, self.value(a[1], kind))
        return f"{name} = {self.raw(a[1], width)};"

    def op_ld(self, words, a):
        kind, registers, pointer, each = self.access(words, a[1], a[0])
        done = pointer
        for place, (name, width) in enumerate(map(register, registers)):
            sign = f"(int{width}_t)({TYPE[kind]})" if kind[0] == "s" else ""
            done += f"{name} = (uint{width}_t){sign}*({each}*)(a_ + {place * BYTES[kind]}); "
        return "{ " + done + "}"

    def op_st(self, words, a):
        kind, registers, pointer, each = self.access(words, a[0], a[1])
        done, width = pointer, 8 * BYTES[kind] if BYTES[kind] > 1 else 16
        for place, name in enumerate(registers):
            done += (f"*({each}*)(a_ + {place * BYTES[kind]}) = "
                     f"({each}){self.raw(name, width)}; ")
        return "{ " + done + "}"

    def access(self, words, memory, registers):
        """Type, registers, the address a_ as C++, type in memory. `volatile` asks for what a relaxed
        atomic access is; the processor's own loads are that."""
        kind = words[-1]
        space = next((word for word in words if word in SPACES), "generic")
        vector = next((int(word[1]) for word in words if re.fullmatch("v[24]", word)), 1)
        if any(word not in SPACES + ("volatile", "v2", "v4", kind) for word in words[1:]):
            raise Unknown(".".join(words))
        registers = [name.strip() for name in registers.strip("{}").split(",")]
        assert len(registers) == vector
        pointer = f"const uint64_t a_ = (uint64_t){self.address(memory, space)}; "
        if vector * BYTES[kind] > 1:
            pointer += f"aligned(a_, {vector * BYTES[kind]}); "
        return kind, registers, pointer, f"uint{8 * BYTES[kind]}_t"

    def op_cvta(self, words, a):
        if words[1] in ("to", "local") and "shared" not in words:
            return f"{register(a[0])[0]} = {self.raw(a[1], 64)};"
        return None

    def op_setp(self, words, a):
        _, how, kind = words
        x, y = self.value(a[1], kind), self.value(a[2], kind)
        if how == "ne" and isFloat(kind):  # ordered: false beside a NaN
            test = f"({x}) < ({y}) || ({x}) > ({y})"
        elif how in COMPARE:
            test = f"({x}) {COMPARE[how]} ({y})"
        elif how in UNORDERED:
            test = f"!(({x}) {UNORDERED[how]} ({y}))"
        elif how in ("nan", "num"):
            test = ("" if how == "nan" else "!") + f"eitherNaN({x}, {y})"
        else:
            return None
        return put(a[0], "pred", test)

    def op_selp(self, words, a):
        name, width = register(a[0])
        return (f"{name} = {register(a[3])[0]} ? {self.raw(a[1], width)} : "
                f"{self.raw(a[2], width)};")

    def bitwise(self, words, a):
        kind = words[-1]
        return put(a[0], kind, f"({self.value(a[1], kind)} {BITWISE[words[0]]} "
                               f"{self.value(a[2], kind)})")

    op_and = op_or = op_xor = bitwise

    def op_not(self, words, a):
        kind = words[-1]
        return put(a[0], kind, ("!" if kind == "pred" else "~") + self.value(a[1], kind))

    def arithmetic(self, words, a):
        return (self.ofNumbers if isFloat(words[-1]) else self.ofIntegers)(words, a)

    op_add = op_sub = op_mul = op_div = op_rem = op_mad = op_fma = op_neg = op_sqrt = arithmetic
    op_rcp = op_min = op_max = op_abs = arithmetic

    def ofNumbers(self, words, a):
        """Rounded to nearest, subnormals kept: nothing else is the same on a processor."""
        name, kind = words[0], words[-1]
        values = [self.value(operand, kind) for operand in a[1:]]
        if name in ("neg", "abs"):
            sign = 1 << (8 * BYTES[kind] - 1)
            mask = f"^ {sign:#x}ull" if name == "neg" else f"& {sign - 1:#x}ull"
            bits = 8 * BYTES[kind]
            return f"{register(a[0])[0]} = (uint{bits}_t)({self.raw(a[1], bits)} {mask});"
        if name in ("min", "max"):
            return put(a[0], kind, f"{name}imum({', '.join(values)})") if len(words) == 2 else None
        if words[1:-1] != ["rn"]:
            return None
        if name in ("add", "sub", "mul", "div"):
            return put(a[0], kind, f"{values[0]} {ARITHMETIC[name]} {values[1]}")
        if name == "rcp":
            return put(a[0], kind, f"{TYPE[kind]}(1) / {values[0]}")
        if name == "fma":
            return put(a[0], kind, f"fused({FUSED}[{self.nextFused()}], {', '.join(values)})")
        return put(a[0], kind, f"{name}Rounded({', '.join(values)})")

    def ofIntegers(self, words, a):
        name, kind = words[0], words[-1]
        whole = TYPE[kind].replace("int", "uint") if kind[0] == "s" else TYPE[kind]
        values = [self.value(operand, kind) for operand in a[1:]]
        if name in ("min", "max"):
            x, y = values
            return put(a[0], kind, f"({x}) {'<' if name == 'min' else '>'} ({y}) ? ({x}) : ({y})")
        if name in ("div", "rem"):
            return put(a[0], kind, f"{values[0]} {ARITHMETIC[name]} {values[1]}")
        if name == "mul" and words[1] == "wide":
            big = {"s32": "int64_t", "u32": "uint64_t", "u16": "uint32_t", "s16": "int32_t"}[kind]
            target, width = register(a[0])
            return f"{target} = (uint{width}_t)(({big})({values[0]}) * ({big})({values[1]}));"
        wraps = [f"({whole})({value})" for value in values]
        if name in ("add", "sub"):
            return put(a[0], kind, f"{wraps[0]} {ARITHMETIC[name]} {wraps[1]}")
        if name == "neg":
            return put(a[0], kind, f"({whole})0 - {wraps[0]}")
        if words[1] != "lo" or name not in ("mul", "mad"):
            return None
        product = f"({whole})(1u * {wraps[0]} * {wraps[1]})"  # 1u: no promotion to int
        return put(a[0], kind, product + (f" + {wraps[2]}" if name == "mad" else ""))

    def shift(self, words, a):
        kind = words[-1].replace("b", "u")
        return put(a[0], kind, f"{words[0]}<{TYPE[kind]}>({self.value(a[1], kind)}, "
                               f"{self.value(a[2], 'u32')})")

    op_shl = op_shr = shift

    def op_bfi(self, words, a):
        if words[-1] != "b32":
            return None
        values = [self.value(operand, "u32") for operand in a[1:]]
        return put(a[0], "b32", f"bfi({', '.join(values)})")

    def op_cvt(self, words, a):
        to, source = words[-2:]
        value, how = self.value(a[1], source), words[1:-2]
        if not isFloat(to) and not isFloat(source):
            name, width = register(a[0])
            return None if how else f"{name} = (uint{width}_t)({TYPE[to]})({value});"
        if (to, source, how) == ("f64", "f32", []):
            return put(a[0], to, f"(double){value}")
        if how == ["rn"] and isFloat(to):
            return put(a[0], to, f"({TYPE[to]}){value}")
        if how == ["rzi"] and isFloat(source):
            return put(a[0], to, f"toInteger<{TYPE[to]}>({value})")
        return put(a[0], to, f"floorOf({value})") if how == ["rmi"] and to == source else None

    def atomic(self, words, a):
        """atom d, [a], b and red [a], b: one thread runs at a time."""
        kind = {"u64": "u64", "b32": "b32"}.get(words[-1])
        what = next((word for word in words if word in ("add", "exch")), None)
        if not what or not kind:
            return None
        memory, value = a[-2], self.value(a[-1], kind)
        done = (f"{{ const uint64_t a_ = (uint64_t){self.address(memory, 'global')}; "
                f"aligned(a_, {BYTES[kind]}); {TYPE[kind]}* q_ = ({TYPE[kind]}*)a_; "
                f"const {TYPE[kind]} o_ = *q_; *q_ = {'o_ + ' if what == 'add' else ''}{value}; ")
        return done + (f"{register(a[0])[0]} = o_; }}" if words[0] == "atom" else "}")

    op_atom = op_red = atomic
