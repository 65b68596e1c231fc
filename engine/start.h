/* start.h -- Prolog with the rules that are in this library, once a process.
 *
 * Layer: engine. Not public: sanggwan.h is.
 */
#ifndef SG_START_H
#define SG_START_H

#include <stdbool.h>

/* Registers the glue, starts Prolog and loads the core of the rules. argv as
 * Prolog's own; it must live as long as the process. False: Prolog could not
 * be started. Must not be called when Prolog already runs. */
bool sg_start(int argc, char **argv);

/* Registers the glue in the Prolog that runs and loads the rules into it,
 * unless they are there (from the pack, or an earlier call). False: the rules
 * could not be loaded, because they were compiled by another version of Prolog
 * or the folder for temporary files cannot be written. */
bool sg_start_inside(void);

#endif
