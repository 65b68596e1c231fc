/* door_types.c -- the simple types of doors: see door.h.
 *
 * Layer: glue.
 */
#include "door.h"

#include "engine/search.h"

#include <SWI-Stream.h>
#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

/* ---- numbers, words ---- */

int
get_int(sg_call *call, term_t t, int32_t *out)
{
  int64_t i;

  (void)call;
  if (!PL_get_int64(t, &i)) {
    if (PL_is_integer(t)) {
      return PL_representation_error("int32");
    }
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("integer", t);
  }
  if (PL_is_float(t)) {
    return PL_type_error("integer", t);
  }
  if (i < INT32_MIN || i > INT32_MAX) {
    return PL_representation_error("int32");
  }
  *out = (int32_t)i;
  return TRUE;
}

int
get_id(sg_call *call, term_t t, int32_t *out)
{
  if (!get_int(call, t, out)) {
    return FALSE;
  }
  return *out > 0 || PL_type_error("not_less_than_one", t);
}

int
get_integer(sg_call *call, term_t t, int64_t *out)
{
  (void)call;
  return PL_get_int64_ex(t, out);
}

int
get_count(sg_call *call, term_t t, size_t *out)
{
  (void)call;
  return PL_get_size_ex(t, out);
}

int
get_number(sg_call *call, term_t t, double *out)
{
  (void)call;
  if (!PL_get_float_ex(t, out)) {
    return FALSE;
  }
  *out += 0.0;
  return isfinite(*out) || PL_domain_error("finite", t);
}

int
get_bool(sg_call *call, term_t t, bool *out)
{
  int is;

  (void)call;
  if (!PL_get_bool_ex(t, &is)) {
    return FALSE;
  }
  *out = is;
  return TRUE;
}

int
get_sense(sg_call *call, term_t t, bool *reversed)
{
  int32_t sense;

  (void)call;
  if (!get_int(call, t, &sense)) {
    return FALSE;
  }
  *reversed = sense == -1;
  return sense == 1 || sense == -1 || PL_domain_error("sense", t);
}

int
get_bytes(sg_call *call, term_t t, sg_bytes *out)
{
  char *text;

  (void)call;
  if (!PL_get_nchars(t, &out->n, &text,
                     CVT_STRING | CVT_EXCEPTION | REP_ISO_LATIN_1)) {
    return FALSE;
  }
  out->at = (const uint8_t *)text;
  return TRUE;
}

int
put_bytes(term_t t, const sg_bytes *x)
{
  return PL_put_variable(t) && PL_unify_chars(t, PL_STRING | REP_ISO_LATIN_1,
                                              x->n, (const char *)x->at);
}

SG_DOOR_GET_LIST(id, sg_int_list, get_id)

int
get_symbol(sg_call *call, term_t t, int32_t *out)
{
  static _Thread_local atom_t last;
  static _Thread_local int32_t symbol;
  atom_t atom;

  if (!PL_get_atom_ex(t, &atom)) {
    return FALSE;
  }
  if (atom != last) {
    symbol = sg_intern_atom(atom);
    last = symbol < 0 ? 0 : sg_symbol_atom(symbol); /* kept for ever */
  }
  *out = symbol;
  return symbol >= 0 || sg_call_no_memory(call);
}

int
put_symbol(term_t t, int32_t symbol)
{
  return PL_put_atom(t, sg_symbol_atom(symbol));
}

/* The text of t in UTF-8, which may have zeros, and a zero behind it. */
static int
get_utf8(sg_call *call, term_t t, unsigned flags, const char **out, size_t *n)
{
  char *text, *kept = NULL;

  PL_STRINGS_MARK();
  if (PL_get_nchars(t, n, &text, flags | CVT_EXCEPTION | REP_UTF8) &&
      (kept = sg_call_alloc(call, *n + 1))) {
    memcpy(kept, text, *n + 1);
  }
  PL_STRINGS_RELEASE();
  *out = kept;
  return kept != NULL;
}

int
get_name(sg_call *call, term_t t, const char **out)
{
  size_t n;

  return get_utf8(call, t, CVT_ATOM | CVT_STRING | CVT_WRITEQ, out, &n);
}

/* ---- streams ---- */

/* The stream for input or output: PL_get_stream() takes one for the other. */
static int
get_stream(term_t t, int way, IOSTREAM **out)
{
  if (!PL_get_stream(t, out, way)) {
    return FALSE;
  }
  if ((*out)->flags & way) {
    return TRUE;
  }
  PL_release_stream_noerror(*out);
  return PL_permission_error(way == SIO_INPUT ? "input" : "output", "stream",
                             t);
}

static size_t
read_stream(void *data, char *to, size_t n)
{
  IOSTREAM *in;

  if (!get_stream((term_t)data, SIO_INPUT, &in)) {
    return SIZE_MAX;
  }
  n = Sfread(to, 1, n, in);
  return PL_release_stream(in) ? n : SIZE_MAX;
}

int
get_input(sg_call *call, term_t t, sg_input *out)
{
  (void)call;
  *out = (sg_input){read_stream, (void *)t};
  return TRUE;
}

/* Writes past the buffer of a binary stream, which Sfwrite() fills byte by
 * byte. Gives what was written; Sfwrite() then writes the rest, or says why
 * not. */
static size_t
write_at_once(IOSTREAM *out, const char *bytes, size_t n)
{
  size_t done = 0;

  if (out->encoding != ENC_OCTET || out->tee || Sflush(out) != 0) {
    return 0;
  }
  while (done < n) {
    ssize_t got =
        out->functions->write(out->handle, (char *)bytes + done, n - done);
    if (got <= 0) {
      break;
    }
    done += (size_t)got;
  }
  if (out->position) {
    out->position->byteno += (int64_t)done;
    out->position->charno += (int64_t)done;
  }
  return done;
}

/* PL_release_stream() raises what went wrong. */
static bool
write_stream(void *data, const char *bytes, size_t n)
{
  IOSTREAM *out;

  if (!get_stream((term_t)data, SIO_OUTPUT, &out)) {
    return false;
  }
  size_t done = write_at_once(out, bytes, n);
  bool good = Sfwrite(bytes + done, 1, n - done, out) == n - done;

  return PL_release_stream(out) && good;
}

int
get_output(sg_call *call, term_t t, sg_output *out)
{
  (void)call;
  *out = (sg_output){write_stream, (void *)t};
  return TRUE;
}

/* Whether every octet is a character that is seen, a space or the end of a
 * line, and the stream has it as that octet, in a buffer. */
static bool
is_plain(const IOSTREAM *out, const char *text, size_t n)
{
  unsigned others = 0;

  for (size_t i = 0; i < n; i++) {
    others |= (text[i] < ' ' || text[i] > '~') & (text[i] != '\n');
  }
  return others == 0 && out->encoding == ENC_UTF8 &&
         out->newline == SIO_NL_POSIX && (out->flags & SIO_FBUF) && !out->tee;
}

static void
move_position(IOPOS *position, const char *text, size_t n)
{
  const char *end = text + n, *newline;

  position->charno += (int64_t)n;
  while ((newline = memchr(text, '\n', (size_t)(end - text)))) {
    position->lineno++;
    position->linepos = 0;
    text = newline + 1;
  }
  position->linepos += (int)(end - text);
}

/* Fills the buffer by as much as it has room for, and empties it by the octet
 * after that: Sputcode() takes each alone. */
static bool
put_plain(IOSTREAM *out, const char *text, size_t n)
{
  for (size_t done = 0; done < n;) {
    size_t room =
        out->bufp < out->limitp ? (size_t)(out->limitp - out->bufp) : 0;
    size_t some = n - done < room ? n - done : room;

    if (some > 0) {
      memcpy(out->bufp, text + done, some);
      out->bufp += some;
      out->lastc = text[done + some - 1];
    }
    done += some;
    if (out->position) {
      out->position->byteno += (int64_t)some;
    }
    if (done < n && Sputc(text[done++], out) < 0) {
      return false;
    }
  }
  if (out->position) {
    move_position(out->position, text, n);
  }
  return true;
}

/* Each character as the stream has it. */
static bool
put_codes(IOSTREAM *out, const char *text, size_t n)
{
  bool good = true;

  for (size_t i = 0; good && i < n;) {
    unsigned lead = (unsigned char)text[i++];
    int more = lead < 0xC0 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
    unsigned code = more == 0 ? lead : lead & (0x3FU >> more);

    for (; more > 0 && i < n; more--) {
      code = code << 6 | ((unsigned char)text[i++] & 0x3F);
    }
    good = Sputcode((int)code, out) >= 0;
  }
  return good;
}

static bool
write_text_stream(void *data, const char *text, size_t n)
{
  IOSTREAM *out;
  bool good;

  if (!get_stream((term_t)data, SIO_OUTPUT, &out)) {
    return false;
  }
  good = is_plain(out, text, n) ? put_plain(out, text, n)
                                : put_codes(out, text, n);
  return PL_release_stream(out) && good;
}

int
get_text_output(sg_call *call, term_t t, sg_output *out)
{
  (void)call;
  *out = (sg_output){write_text_stream, (void *)t};
  return TRUE;
}

/* A string, or a file, being read. */
typedef struct text_source {
  const char *text; /* null: a file */
  size_t n;
  int file;
  off_t at;
} text_source;

/* What cannot be read is the reader's to say. */
static size_t
read_text(void *data, char *to, size_t n)
{
  text_source *from = data;
  ssize_t got;

  if (!from->text) {
    do {
      got = pread(from->file, to, n, from->at);
    } while (got < 0 && errno == EINTR);
    from->at += got > 0 ? got : 0;
    return got > 0 ? (size_t)got : 0;
  }
  n = n < from->n ? n : from->n;
  memcpy(to, from->text, n);
  from->text += n;
  from->n -= n;
  return n;
}

int
get_text(sg_call *call, term_t t, sg_input *out)
{
  text_source *from = sg_call_alloc(call, sizeof *from);
  IOSTREAM *in;

  *out = (sg_input){read_text, from};
  if (!from) {
    return FALSE;
  }
  *from = (text_source){0};
  if (PL_is_string(t)) {
    return get_utf8(call, t, CVT_STRING, &from->text, &from->n);
  }
  if (!get_stream(t, SIO_INPUT, &in)) {
    return FALSE;
  }
  from->file = Sfileno(in);
  return PL_release_stream(in);
}

/* As text: PL_get_mpq() of 9.0.4 fails. */
int
get_exact(sg_call *call, term_t t, sg_exact *out)
{
  char *text, *bar, *kept = NULL;
  size_t n;

  out->text = NULL;
  if (!PL_is_rational(t)) {
    return get_number(call, t, &out->number);
  }
  PL_STRINGS_MARK();
  if (PL_get_nchars(t, &n, &text, CVT_RATIONAL | CVT_INTEGER | CVT_EXCEPTION) &&
      (kept = sg_call_alloc(call, n + 1))) {
    memcpy(kept, text, n + 1);
  }
  PL_STRINGS_RELEASE();
  if (kept && (bar = strchr(kept, 'r'))) {
    *bar = '/';
  }
  out->text = kept;
  return kept != NULL;
}

int
get_set_id(sg_call *call, term_t t, sg_int_list *out)
{
  if (!get_list_id(call, t, out)) {
    return FALSE;
  }
  out->n = sg_sort_ids(out->at, out->n);
  return TRUE;
}
