/* text_limits_rows.c -- texts looked through before they are read. See
 * rules/limits.pl.
 *
 * Layer: rows.
 */
#include "doors/file.h"

enum { CHUNK = 4096 }; /* on the stack, which may be small */

/* Looks through a text to its end, or its first fault. */
static void
look_through(sg_call *call, const sg_input *source, sg_text_scan *scan)
{
  char bytes[CHUNK];
  size_t n;

  do {
    n = sg_call_read(call, source, bytes, sizeof bytes);
  } while (n > 0 && sg_text_scan_feed(scan, bytes, n));
}

/* False: refused. */
static bool
close_scan(sg_call *call, sg_text_scan *scan, sg_text_fault_place *fault)
{
  sg_text_scan_close(scan);
  *fault = (sg_text_fault_place){scan->fault, scan->line, scan->column};
  return scan->fault != SG_TEXT_NO_MEMORY || sg_call_no_memory(call);
}

bool
sg_door_text_fault(sg_call *call, sg_text_kind kind, const sg_input *source,
                   const sg_text_limits *limits, sg_text_fault_place *fault)
{
  sg_text_scan scan;

  sg_text_scan_open(&scan, kind, limits);
  look_through(call, source, &scan);
  return close_scan(call, &scan, fault) && scan.fault != SG_TEXT_GOOD;
}

bool
sg_door_text_copied(sg_call *call, sg_text_kind kind, const sg_input *begun,
                    const sg_input *in, const sg_output *out,
                    const sg_text_limits *limits, size_t most, size_t *copied,
                    sg_text_fault_place *fault)
{
  enum { PART = 1 << 16 };
  char *bytes = sg_call_alloc(call, PART);
  sg_text_scan scan;
  size_t n = 0;
  bool good = bytes != NULL;

  *copied = 0;
  sg_text_scan_open(&scan, kind, limits);
  if (good) {
    look_through(call, begun, &scan);
  }
  while (good && !scan.fault && *copied < most) {
    size_t left = most - *copied;

    n = sg_call_read(call, in, bytes, left < PART ? left : PART);
    if (n == 0) {
      break;
    }
    good = out->write(out->data, bytes, n);
    sg_text_scan_feed(&scan, bytes, n);
    *copied += n;
  }
  return close_scan(call, &scan, fault) && good && !call->stopped;
}
