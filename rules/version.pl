:- module(sg_version,
          [ version/1                   % -Text
          ]).
/** <module> Which Sanggwan this is.
*/

%!  version(-Text:atom) is det.

version('0.2.0').
