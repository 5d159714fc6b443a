// The words that languages keep for themselves. A program writes names of the chart as fields of
// its records, so functions and types of a language do not get in their way, but keywords and
// macros do.

#include "plc/shared/language_words.h"

#include <algorithm>
#include <iterator>

#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr std::string_view c_words[] = {
    // C99 and C11
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict",
    "return", "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union",
    "unsigned", "void", "volatile", "while",
    // C23 and C++20
    "alignas", "alignof", "and", "and_eq", "asm", "bitand", "bitor", "bool", "catch", "char16_t",
    "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl", "concept",
    "const_cast", "consteval", "constexpr", "constinit", "decltype", "delete", "dynamic_cast",
    "explicit", "export", "false", "friend", "mutable", "namespace", "new", "noexcept", "not",
    "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected", "public",
    "reinterpret_cast", "requires", "static_assert", "static_cast", "template", "this",
    "thread_local", "throw", "true", "try", "typeid", "typename", "typeof", "typeof_unqual",
    "using", "virtual", "wchar_t", "xor", "xor_eq"};

// Patterns of words: `#` stands for a digit and `@` for one of the letters A to L, which ports and
// registers are counted with; `*` at an end for any text.

/// Macros of stdbool.h, stdint.h, stdio.h and string.h (glibc 2.36, C99 and C++), and those that
/// compilers define for their systems.
// clang-format off
constexpr std::string_view c_macros[] = {
    "BUFSIZ", "EOF", "FILENAME_MAX", "FOPEN_MAX", "INT#_C", "INT#_MAX", "INT#_MIN",
    "INT#_WIDTH", "INT##_C", "INT##_MAX", "INT##_MIN", "INT##_WIDTH", "INTMAX_*", "INTPTR_*",
    "INT_FAST*", "INT_LEAST*", "L_ctermid", "L_cuserid", "L_tmpnam", "NULL", "PTRDIFF_*",
    "P_tmpdir", "RENAME_*", "SEEK_*", "SIG_ATOMIC_*", "SIZE_MAX", "SIZE_WIDTH", "TMP_MAX",
    "UINT#_C", "UINT#_MAX", "UINT#_WIDTH", "UINT##_C", "UINT##_MAX", "UINT##_WIDTH",
    "UINTMAX_*", "UINTPTR_*", "UINT_FAST*", "UINT_LEAST*", "WCHAR_*", "WINT_*", "errno",
    "i386", "linux", "offsetof", "stderr", "stdin", "stdout", "strdupa", "strndupa", "unix"};

/// What Arduino.h defines on the boards with a processor of the AVR family: all macros of the
/// Arduino AVR core 1.8.7 and avr-libc 2.0.0 for ATmega328P, ATmega168, ATmega2560 and ATmega32U4,
/// those of the command line (F_CPU, ARDUINO), and the types of the core. The numbers in binary.h
/// are in is_binary_number().
constexpr std::string_view arduino_macros[] = {
    "*_vect", "*_vect_num", "ACBG", "ACD", "ACI", "ACIC", "ACIE", "ACIS#", "ACME", "ACO",
    "ACSR", "ADATE", "ADC", "ADC##D", "ADC#D", "ADCH", "ADCH#", "ADCL", "ADCL#", "ADCSRA",
    "ADCSRB", "ADCW", "ADDEN", "ADEN", "ADHSM", "ADIE", "ADIF", "ADLAR", "ADMUX", "ADPS#",
    "ADSC", "ADTS#", "AIN#D", "ALLOC", "ARDUINO", "ARDUINO_*", "AS#", "ASSR", "AVR", "AVR_*",
    "BIN", "BLB#_MODE_#", "BLBSET", "BODS", "BODSE", "BORF", "BYCT#", "CAL#", "CDC_*", "CFGOK",
    "CHANGE", "CLEAR_FEATURE", "CLKPCE", "CLKPR", "CLKPS#", "CLKS", "CLKSEL#", "CLKSTA",
    "COM#A#", "COM#A#S", "COM#B#", "COM#B#S", "COM#C#", "COM#D#", "CPHA", "CPOL", "CS##",
    "CTRLDIR", "CTSEN", "CURRBK#", "DAT#", "DD#", "DD@#", "DDR@", "DEC", "DEFAULT",
    "DEG_TO_RAD", "DETACH", "DEVICE_REMOTE_WAKEUP", "DIDR#", "DISPLAY", "DOR#", "DORD", "DT#",
    "DT#L#", "DTOSTR_*", "DTPS##", "DTSEQ#", "D_CDCCS", "D_CDCCS#", "D_CONFIG", "D_DEVICE",
    "D_ENDPOINT", "D_IAD", "D_INTERFACE", "E#END", "E#PAGESIZE", "EEAR", "EEAR#", "EEAR##",
    "EEARH", "EEARL", "EECR", "EEDR", "EEDR#", "EEMEM", "EEMPE", "EEPE", "EEPM#", "EERE",
    "EERIE", "EFUSE_DEFAULT", "EICRA", "EICRB", "EIFR", "EIMSK", "EIND", "EIND#",
    "EMPTY_INTERRUPT", "ENDPOINT_HALT", "ENHC#", "EORSME", "EORSMI", "EORSTE", "EORSTI",
    "EPBK#", "EPDIR", "EPEN", "EPINT#", "EPRST#", "EPSIZE#", "EPTYPE#", "EP_TYPE_*", "EULER",
    "EXCKSEL#", "EXCLK", "EXIT_FAILURE", "EXIT_SUCCESS", "EXSUT#", "EXTE", "EXTERNAL", "EXTON",
    "EXTRF", "F", "FALLING", "FDEV_SETUP_STREAM", "FE#", "FEATURE_REMOTE_WAKEUP_ENABLED",
    "FEATURE_SELFPOWERED_ENABLED", "FIFOCON", "FLASHEND", "FLERRE", "FNCERR", "FNUM#",
    "FNUM##", "FOC#A", "FOC#B", "FOC#C", "FOC#D", "FPAC#", "FPEN#", "FPES#", "FPF#", "FPIE#",
    "FPNC#", "FRZCLK", "FUSEMEM", "FUSES", "FUSE_*", "F_CPU", "GET_CONFIGURATION",
    "GET_DESCRIPTOR", "GET_INTERFACE", "GET_STATUS", "GPIOR#", "GPIOR##", "GTCCR", "HALF_PI",
    "HAVE_*", "HEX", "HFUSE_DEFAULT", "HIGH", "ICES#", "ICF#", "ICIE#", "ICNC#", "ICR#",
    "ICR#H", "ICR#H#", "ICR#L", "ICR#L#", "IDRD", "IMANUFACTURER", "INFINITY", "INPUT",
    "INPUT_PULLUP", "INT#", "INTERFACE_COUNT", "INTERNAL", "INTERNAL#V#", "INTERNAL#V##",
    "INTF#", "INTMAX_C", "IPRODUCT", "ISC##", "ISERIAL", "ISERIAL_MAX_LEN", "ISR", "ISR_*",
    "IVCE", "IVSEL", "JTD", "JTRF", "LB_MODE_#", "LED_BUILTIN", "LED_BUILTIN_RX",
    "LED_BUILTIN_TX", "LFUSE_DEFAULT", "LOCKBITS", "LOCKBITS_DEFAULT", "LOCKMEM", "LOW",
    "LSBFIRST", "LSM", "MAGIC_KEY", "MAGIC_KEY_POS", "MCUCR", "MCUSR", "MONDR", "MPCM#",
    "MSBFIRST", "MSC_GET_MAX_LUN", "MSC_PROTOCOL_BULK_ONLY", "MSC_RESET", "MSC_SUBCLASS_SCSI",
    "MSTR", "MUX#", "M_#_PI", "M_#_SQRTPI", "M_E", "M_LN#", "M_LN##", "M_LOG##E", "M_LOG#E",
    "M_PI", "M_PI_#", "M_SQRT#", "M_SQRT#_#", "NAKINE", "NAKINI", "NAKOUTE", "NAKOUTI", "NAN",
    "NBUSYBK#", "NEW_LUFA_SIGNATURE", "NOT_AN_INTERRUPT", "NOT_A_PIN", "NOT_A_PORT",
    "NOT_ON_TIMER", "NUM_ANALOG_INPUTS", "NUM_DIGITAL_PINS", "OC#OE#", "OCDR", "OCDR#",
    "OCF#A", "OCF#B", "OCF#C", "OCF#D", "OCIE#A", "OCIE#B", "OCIE#C", "OCIE#D", "OCR#A",
    "OCR#A#", "OCR#AH", "OCR#AH#", "OCR#AL", "OCR#AL#", "OCR#AUB", "OCR#A_#", "OCR#B",
    "OCR#B#", "OCR#BH", "OCR#BH#", "OCR#BL", "OCR#BL#", "OCR#BUB", "OCR#B_#", "OCR#C",
    "OCR#C#", "OCR#CH", "OCR#CH#", "OCR#CL", "OCR#CL#", "OCR#D", "OCR#D#", "OCR#_#", "OCT",
    "OSCCAL", "OTGPADE", "OUTPUT", "OVERFI", "P@#", "PCICR", "PCIE#", "PCIF#", "PCIFR",
    "PCINT#", "PCINT##", "PCMSK#", "PDIV#", "PGERS", "PGM_P", "PGM_VOID_P", "PGWRT", "PI",
    "PIN#", "PIN@", "PIN@#", "PINDIV", "PINMUX", "PIN_A#", "PIN_A##", "PIN_SPI_MISO",
    "PIN_SPI_MOSI", "PIN_SPI_SCK", "PIN_SPI_SS", "PIN_WIRE_SCL", "PIN_WIRE_SDA", "PLLCSR",
    "PLLE", "PLLFRQ", "PLLTM#", "PLLUSB", "PLOCK", "PLUGGABLE_USB_ENABLED", "PORF", "PORT#",
    "PORT@", "PORT@#", "PRADC", "PRIX*", "PRId*", "PRIi*", "PRIo*", "PRIu*", "PRIx*",
    "PROGMEM", "PRR", "PRR#", "PRSPI", "PRTIM#", "PRTWI", "PRUSART#", "PRUSB", "PSR#",
    "PSRASY", "PSRSYNC", "PSTR", "PUD", "PWM#A", "PWM#B", "PWM#D", "PWM#X", "RAD_TO_DEG",
    "RAMEND", "RAMPZ", "RAMPZ#", "RAMSIZE", "RAMSTART", "RANDOM_MAX", "RAND_MAX", "RCCKSEL#",
    "RCCTRL", "RCE", "RCFREQ", "RCON", "RCSUT#", "REFS#", "REQUEST_*", "RISING", "RMWKUP",
    "RSTCPU", "RSTDT", "RTSEN", "RWAL", "RWWSB", "RWWSRE", "RXB##", "RXC#", "RXCIE#", "RXEN#",
    "RXLED#", "RXOUTE", "RXOUTI", "RXSTPE", "RXSTPI", "SCNd*", "SCNi*", "SCNo*", "SCNu*",
    "SCNx*", "SE", "SEEK_CUR", "SEEK_END", "SEEK_SET", "SELFPRGEN", "SERIAL", "SERIAL_*",
    "SET_ADDRESS", "SET_CONFIGURATION", "SET_DESCRIPTOR", "SET_FEATURE", "SET_INTERFACE",
    "SIGNAL", "SIGNATURE_#", "SIGRD", "SIG_*", "SLEEP_MODE_*", "SM#", "SMCR", "SOFE", "SOFI",
    "SP", "SPCR", "SPDR", "SPDR#", "SPE", "SPEED", "SPH", "SPI#X", "SPIE", "SPIF", "SPL",
    "SPMCSR", "SPMEN", "SPMIE", "SPM_PAGESIZE", "SPR#", "SPSR", "SRE", "SREG", "SREG_*",
    "SRL#", "SRW##", "STALLEDE", "STALLEDI", "STALLRQ", "STALLRQC", "SUSPE", "SUSPI",
    "SerialUSB", "String", "TC##", "TC###", "TC#H", "TCCR#@", "TCN#UB", "TCNT#", "TCNT#H",
    "TCNT#H#", "TCNT#L", "TCNT#L#", "TCNT#_#", "TCR#AUB", "TCR#BUB", "TEST_MODE", "TIFR#",
    "TIMER#", "TIMER#A", "TIMER#B", "TIMER#C", "TIMER#D", "TIMSK#", "TLOCK#", "TOBYTES",
    "TOIE#", "TOV#", "TRANSFER_*", "TSM", "TWA#", "TWAM#", "TWAMR", "TWAR", "TWBR", "TWBR#",
    "TWCR", "TWD#", "TWDR", "TWEA", "TWEN", "TWGCE", "TWIE", "TWINT", "TWO_PI", "TWPS#",
    "TWS#", "TWSR", "TWSTA", "TWSTO", "TWWC", "TXB##", "TXC#", "TXCIE#", "TXEN#", "TXINE",
    "TXINI", "TXLED#", "TX_RX_LED_INIT", "U#X#", "UADD#", "UBRR#", "UBRR#H", "UBRR#L",
    "UBRR#_#", "UBRR#_##", "UCPHA#", "UCPOL#", "UCSR#A", "UCSR#B", "UCSR#C", "UCSR#D",
    "UCSZ##", "UDADDR", "UDCON", "UDFNUM", "UDFNUMH", "UDFNUML", "UDIEN", "UDINT", "UDMFN",
    "UDORD#", "UDR#", "UDR#_#", "UDRE#", "UDRIE#", "UEBCHX", "UEBCLX", "UEBCX", "UECFG#X",
    "UECONX", "UEDATX", "UEIENX", "UEINT", "UEINTX", "UENUM", "UENUM_#", "UERST", "UESTA#X",
    "UHWCON", "UINTMAX_C", "UMSEL##", "UNDERFI", "UPE#", "UPM##", "UPRSME", "UPRSMI", "USBCON",
    "USBE", "USBINT", "USBS#", "USBSTA", "USB_*", "UVREGE", "VBUS", "VBUSTE", "VBUSTI",
    "WAKEUPE", "WAKEUPI", "WCOL", "WDCE", "WDE", "WDIE", "WDIF", "WDP#", "WDRF", "WDTCSR",
    "WGM##", "XH", "XL", "XMBK", "XMCRA", "XMCRB", "XMM#", "XRAMEND", "XRAMSIZE", "XRAMSTART",
    "YH", "YL", "ZH", "ZL", "abs", "acosf", "analogInPinToBit", "analogInputToDigitalPin",
    "analogPinToChannel", "asinf", "atan#f", "atanf", "bit", "bitClear", "bitRead", "bitSet",
    "bitToggle", "bitWrite", "bit_is_clear", "bit_is_set", "boolean", "byte", "cbrtf", "ceilf",
    "clearerror", "cli", "clockCyclesPerMicrosecond", "clockCyclesToMicroseconds", "constrain",
    "copysignf", "cosf", "coshf", "degrees", "digitalPinHasPWM", "digitalPinToBitMask",
    "digitalPinToInterrupt", "digitalPinToPCICR", "digitalPinToPCICRbit", "digitalPinToPCMSK",
    "digitalPinToPCMSKbit", "digitalPinToPort", "digitalPinToTimer", "eeprom_busy_wait",
    "eeprom_is_ready", "expf", "fabsf", "fdev_*", "fdimf", "feof", "ferror", "floorf", "fmaf",
    "fmaxf", "fminf", "fmodf", "frexpf", "getc", "getchar", "highByte", "hypotf", "interrupts",
    "isfinitef", "isinff", "isnanf", "labs", "ldexpf", "log##f", "logf",
    "loop_until_bit_is_clear", "loop_until_bit_is_set", "lowByte", "lrintf", "lroundf", "max",
    "microsecondsToClockCycles", "min", "noInterrupts", "pgm_*", "portInputRegister",
    "portModeRegister", "portOutputRegister", "powf", "putc", "putchar", "radians", "reti",
    "round", "roundf", "sei", "signbitf", "sinf", "sinhf", "sq", "squaref", "tanf", "tanhf",
    "truncf", "va_arg", "va_copy", "va_end", "va_start", "word"};
// clang-format on

constexpr std::string_view pascal_words[] = {"absolute",
                                             "and",
                                             "array",
                                             "as",
                                             "asm",
                                             "begin",
                                             "bitpacked",
                                             "case",
                                             "class",
                                             "const",
                                             "constructor",
                                             "destructor",
                                             "dispinterface",
                                             "div",
                                             "do",
                                             "downto",
                                             "else",
                                             "end",
                                             "except",
                                             "exports",
                                             "false",
                                             "file",
                                             "finalization",
                                             "finally",
                                             "for",
                                             "function",
                                             "goto",
                                             "if",
                                             "implementation",
                                             "in",
                                             "inherited",
                                             "initialization",
                                             "inline",
                                             "interface",
                                             "is",
                                             "label",
                                             "library",
                                             "mod",
                                             "nil",
                                             "not",
                                             "object",
                                             "of",
                                             "on",
                                             "operator",
                                             "or",
                                             "out",
                                             "packed",
                                             "procedure",
                                             "program",
                                             "property",
                                             "raise",
                                             "record",
                                             "reintroduce",
                                             "repeat",
                                             "resourcestring",
                                             "self",
                                             "set",
                                             "shl",
                                             "shr",
                                             "string",
                                             "then",
                                             "threadvar",
                                             "to",
                                             "true",
                                             "try",
                                             "type",
                                             "unit",
                                             "until",
                                             "uses",
                                             "var",
                                             "while",
                                             "with",
                                             "xor"};

constexpr std::string_view python_words[] = {
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

template <std::size_t size>
bool holds(const std::string_view (&words)[size], std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

bool fits(std::string_view pattern, std::string_view word) {
    if (pattern.front() == '*') return word.ends_with(pattern.substr(1));
    if (pattern.back() == '*') return word.starts_with(pattern.substr(0, pattern.size() - 1));
    return std::equal(pattern.begin(), pattern.end(), word.begin(), word.end(), [](char p, char c) {
        if (p == '#') return is_digit(c);
        return p == '@' ? c >= 'A' && c <= 'L' : p == c;
    });
}

template <std::size_t size>
bool fits_one(const std::string_view (&patterns)[size], std::string_view word) {
    return std::any_of(std::begin(patterns), std::end(patterns),
                       [&](std::string_view pattern) { return fits(pattern, word); });
}

/// `B0` to `B11111111` of binary.h.
bool is_binary_number(std::string_view word) {
    return word.size() >= 2 && word.size() <= 9 && word.front() == 'B' &&
           word.find_first_not_of("01", 1) == std::string_view::npos;
}

}  // namespace

bool is_c_word(std::string_view word) {
    return holds(c_words, word) || fits_one(c_macros, word);
}

bool is_arduino_word(std::string_view word) {
    return is_c_word(word) || fits_one(arduino_macros, word) || is_binary_number(word);
}

bool is_pascal_word(std::string_view word) {
    return holds(pascal_words, word);
}

bool is_python_word(std::string_view word) {
    return holds(python_words, word);
}

}  // namespace grafwire
