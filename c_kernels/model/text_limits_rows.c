/* text_limits_rows.c -- texts looked through before they are read. See
 * rules/limits.pl.
 *
 * Layer: rows.
 */
#include "doors/file.h"

enum { CHUNK = 4096 }; /* on the stack, which may be small */

bool
sg_door_text_fault(sg_call *call, sg_text_kind kind, const sg_input *source,
                   const sg_text_limits *limits, sg_text_fault_place *fault)
{
  char bytes[CHUNK];
  sg_text_scan scan;
  size_t n;
  bool good = true;

  sg_text_scan_open(&scan, kind, limits);
  while ((n = sg_call_read(call, source, bytes, sizeof bytes)) > 0 && good) {
    good = sg_text_scan_feed(&scan, bytes, n);
  }
  sg_text_scan_close(&scan);
  *fault = (sg_text_fault_place){scan.fault, scan.line, scan.column};
  return scan.fault == SG_TEXT_NO_MEMORY ? sg_call_no_memory(call)
                                         : scan.fault != SG_TEXT_GOOD;
}
