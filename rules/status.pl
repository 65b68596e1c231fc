:- module(sg_status,
          [ error_status/2              % +Error, -Status
          ]).
/** <module> What an error means to those outside: the exit status.
*/

%!  error_status(+Error, -Status) is det.
%
%   Status is 3 when the input is unreadable or invalid, 4 when the geometry or
%   the memory does not allow it, and 2 otherwise: wrong usage, or an error of a
%   program.

error_status(error(Formal, _), Status) :-
    nonvar(Formal),
    formal_status(Formal, Status),
    !.
error_status(_, 2).

formal_status(usage_error(_), 2).
formal_status(model_error(_), 3).
formal_status(geometry_error(_), 4).
formal_status(resource_error(_), 4).
formal_status(io_error(read, _), 3).
formal_status(representation_error(float32), 4).
