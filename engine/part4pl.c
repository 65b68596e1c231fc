/* part4pl.c -- the rules that the program carries and has not loaded
 * (rules/part.pl; documented in rules/kernel/file.pl).
 *
 * Layer: glue.
 */
#include "install.h"

#include <SWI-Stream.h>

/* carried.S has them; what is loaded into plain Prolog has none. */
extern const unsigned char sg_parts[] __attribute__((weak));
extern const unsigned char sg_parts_end[] __attribute__((weak));

/* program_part(+From, +Bytes, -Stream) is semidet. */
static foreign_t
program_part(term_t from, term_t bytes, term_t stream)
{
  size_t all = sg_parts ? (size_t)(sg_parts_end - sg_parts) : 0;
  size_t first, n;
  IOSTREAM *in;

  if (!PL_get_size_ex(from, &first) || !PL_get_size_ex(bytes, &n) ||
      first > all || n > all - first) {
    return FALSE;
  }
  in = Sopen_string(NULL, (char *)(sg_parts + first), n, "r");
  if (!in) {
    return PL_resource_error("memory");
  }
  Ssetenc(in, ENC_OCTET, NULL);
  if (PL_unify_stream(stream, in)) {
    return TRUE;
  }
  Sclose(in);
  return FALSE;
}

static const PL_extension predicates[] = {
    {"program_part", 3, program_part, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_part(void)
{
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
