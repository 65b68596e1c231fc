/* mesh_number_test.c -- numbers of mesh files: read, printed, in any locale. */
#include "tests/check.h"

#include "mesh_reads.h"
#include "number/number.h"

#include <locale.h>
#include <math.h>

static double
number(const char *text)
{
  double x;

  return sg_number_read(text, strlen(text), &x, NULL) == SG_NUMBER_OK ? x
                                                                      : 12345;
}

static bool
prints(double x, const char *text)
{
  char out[SG_NUMBER_SIZE];
  size_t n = sg_number_print(x, out);

  return n == strlen(text) && !strcmp(out, text);
}

static sg_number
status(const char *text)
{
  double x;

  return sg_number_read(text, strlen(text), &x, NULL);
}

static void
test_reading_numbers(void)
{
  CHECK("integer", number("-12") == -12);
  CHECK("point", number(".5") == 0.5 && number("5.") == 5);
  CHECK("exponent", number("2.000000e+01") == 20 && number("1E-2") == 0.01);
  CHECK("nearest", number("0.1") == 0.1 && number("123456789.123456789e-5") ==
                                               123456789.123456789e-5);
  CHECK("long",
        number("0.1000000000000000055511151231257827021181583404541") == 0.1);
  CHECK("half way", number("9007199254740993") == 9007199254740992.0);
  CHECK("smallest", number("4.9e-324") == 4.9e-324);
  CHECK("too small", number("1e-400") == 0);
  CHECK("no minus zero", !signbit(number("-0.0")));
  CHECK("words", status("blah") == SG_NUMBER_BAD);
  CHECK("empty", status("") == SG_NUMBER_BAD && status("-") == SG_NUMBER_BAD);
  CHECK("parts", status("1e") == SG_NUMBER_BAD && status(".") == SG_NUMBER_BAD);
  CHECK("tail",
        status("1x") == SG_NUMBER_BAD && status("0x10") == SG_NUMBER_BAD);
  CHECK("comma", status("1,5") == SG_NUMBER_BAD);
  CHECK("nan", status("-nan(ind)") == SG_NUMBER_NOT_FINITE);
  CHECK("inf", status("Infinity") == SG_NUMBER_NOT_FINITE);
  CHECK("old windows", status("1.#QNAN") == SG_NUMBER_NOT_FINITE);
  CHECK("overflow", status("1e400") == SG_NUMBER_NOT_FINITE);
}

static void
test_printing_numbers(void)
{
  CHECK("zero", prints(0, "0") && prints(-0.0, "0"));
  CHECK("short", prints(0.1, "0.1") && prints(-12, "-12"));
  CHECK("tail", prints(0.30000000000000004, "0.30000000000000004"));
  CHECK("small", prints(1e-20, "1e-20") && prints(0.00123, "0.00123"));
  CHECK("large", prints(123456789012345.0, "123456789012345"));
  CHECK("largest", number("1.7976931348623157e308") == 0x1.fffffffffffffp1023);
  unsigned long long seed = 88172645463325252u;
  bool same = true;
  for (int i = 0; i < 20000; i++) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    double x = ldexp((double)(long long)seed, (int)(seed % 120) - 110);
    char out[SG_NUMBER_SIZE];
    sg_number_print(x, out);
    same = same && number(out) == x;
  }
  CHECK("20000 doubles read back", same);
}

static void
test_locale(void)
{
  if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8")) {
    printf("skipped: no locale with a decimal comma is installed\n");
    return;
  }
  CHECK("slow way", number("0.30000000000000004") == 0.30000000000000004);
  CHECK("print", prints(0.30000000000000004, "0.30000000000000004"));
  setlocale(LC_ALL, "C");
}

int
main(void)
{
  test_reading_numbers();
  test_printing_numbers();
  test_locale();
  sg_mesh_clear(&mesh);
  return check_report();
}
