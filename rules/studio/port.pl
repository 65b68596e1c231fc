:- module(sg_port,
          [ view_port/2,                % +Head, -Port
            viewed/4                    % :Draw, +Head, -Reply, -Octets
          ]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../output', [copied_to/3]).
:- use_module('../store', [facts_snapshot/1]).
:- use_module(job, [captured/2]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(lists), [member/2]).
/** <module> A port of a session: one picture of the document, as a body.
*/

:- meta_predicate viewed(2, +, -, -).

%!  view_port(+Head:dict, -Port:string) is det.
%
%   Port is that of the request `view`; the newest view of a port is done alone.

view_port(Head, Port) :-
    (   get_dict(port, Head, Port0)
    ->  (   string(Port0)
        ->  Port = Port0
        ;   request_error(bad_key(port, port))
        )
    ;   Port = ""
    ).

request_error(What) :-
    throw(error(request_error(What), _)).

%!  viewed(:Draw, +Head:dict, -Reply:dict, -Octets) is det.
%
%   Octets are the picture of the current world that Head asks for; the world is
%   as before.
%
%   @error request_error(bad_key(Key, Wanted)), errors of Draw

viewed(Draw, Head, Reply, Octets) :-
    view_format(Head, Format),
    findall(Option, view_option(Head, Option), Options),
    get_time(T0),
    captured(objects_heard(
                 facts_snapshot(
                     copied_to(-, Format, sg_port:drawn(Draw, Options))),
                 Objects0),
             Octets),
    get_time(T1),
    exclude(of_writing, Objects0, Objects),
    Ms is (T1-T0)*1000,
    view_port(Head, Port),
    atom_string(Format, Kind),
    Reply = _{port:Port, kind:Kind, messages:Objects, ms:Ms}.

:- public drawn/3.

drawn(Draw, Options, File) :-
    call(Draw, File, Options).

of_writing(Object) :-
    Object.code == "wrote".

view_format(Head, Format) :-
    (   get_dict(format, Head, Text)
    ->  (   memberchk(Text, ["svg","json","pdf","png","dxf"])
        ->  atom_string(Format, Text)
        ;   request_error(bad_key(format, format))
        )
    ;   Format = svg
    ).

%   view_option(Head, Option): of draw/2.

view_option(Head, Option) :-
    get_dict(view, Head, View),
    (   string(View)
    ->  atom_string(Name, View),
        Option = view(Name)
    ;   View = [Theta,Phi],
        number(Theta),
        number(Phi)
    ->  Option = view(Theta, Phi)
    ;   View = [Theta,Phi,Rho],
        number(Theta),
        number(Phi),
        number(Rho)
    ->  Option = view(Theta, Phi, Rho)
    ;   request_error(bad_key(view, view))
    ).
view_option(Head, Option) :-
    member(Key-Words, [ projection-["parallel","central"],
                        lines-["feature","all","penetration"],
                        hidden-["dashed","removed","shown"],
                        up-["x","y","z"] ]),
    get_dict(Key, Head, Text),
    (   memberchk(Text, Words)
    ->  atom_string(Word, Text),
        Option =.. [Key,Word]
    ;   request_error(bad_key(Key, one_of(Words)))
    ).
view_option(Head, crease(Degrees)) :-
    get_dict(crease, Head, Degrees),
    (   number(Degrees),
        Degrees >= 0
    ->  true
    ;   request_error(bad_key(crease, positive))
    ).
view_option(Head, size(Size)) :-
    get_dict(size, Head, Size0),
    (   Size0 = [W,H],
        number(W),
        number(H)
    ->  Size = W-H
    ;   request_error(bad_key(size, size))
    ).
view_option(Head, segments(Segments)) :-
    get_dict(segments, Head, Segments),
    (   is_list(Segments),
        forall(member(S, Segments), integer(S))
    ->  true
    ;   request_error(bad_key(segments, segments))
    ).
