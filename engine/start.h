/* start.h -- starts Prolog with the saved rules, once a process.
 *
 * Layer: engine. Not public: sanggwan.h is.
 */
#ifndef SG_START_H
#define SG_START_H

#include <stdbool.h>

/* Registers the glue and starts Prolog from the state in this program. argv as
 * Prolog's own; it must live as long as the process. False: Prolog could not
 * be started. Must not be called when Prolog already runs. */
bool sg_start(int argc, char **argv);

#endif
