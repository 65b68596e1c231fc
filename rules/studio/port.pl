:- module(sg_port,
          [ view_port/2,                % +Head, -Port
            viewed/4,                   % +World, +Head, -Reply, -Octets
            with_picture/3,             % +World, +Head, :Goal
            drawing_body/3,             % +Drawing, -Reply, -Octets
            strokes_body/4              % +Strokes, -Looks, -Count, -Octets
          ]).
:- use_module('../drawing/drawing',
              [drawing_format/2, write_drawing_stream/3]).
:- use_module('../kernel', 
              [scene_close/1, scene_mesh/5, stroke_octets/3, view_range/5]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../picture/hidden_lines', [open_scene/2, picture/1]).
:- use_module('../picture/role', [usual_crease/1]).
:- use_module('../picture/view',
              [ current_view/4, named_view/3, set_projection/1, set_view/1,
                set_view/3, turn_up/1, with_up/2 ]).
:- use_module('../sheet/sheet', [sheet_strokes/5]).
:- use_module('../sheet/stroke', [all_strokes/2]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../store', [drawn/7, segment/3]).
:- use_module(job, [printed_octets/3]).
:- use_module(port_cut, [cut_picture/4]).
:- use_module(section_name, [named_strokes/3]).
:- use_module(world_state, [in_state/3, state_messages/3]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/2, maplist/3, partition/4]).
:- use_module(library(lists), [append/3, list_to_set/2, member/2]).
:- use_module(library(option), [option/3]).
/** <module> A port of a session: one picture of the document, as a body.
*/

:- meta_predicate with_picture(+, +, 0).

%!  view_port(+Head:dict, -Port:string) is det.
%
%   Port is that of the request `view`; the newest view of a port is done
%   alone.

view_port(Head, Port) :-
    (   get_dict(port, Head, Port0)
    ->  (   string(Port0)
        ->  Port = Port0
        ;   request_error(bad_key(port, port))
        )
    ;   Port = ""
    ).

%!  viewed(+World, +Head:dict, -Reply:dict, -Octets) is det.
%
%   Octets are the picture of World that Head asks for.
%
%   @error request_error(bad_key(Key, Wanted)), geometry_error(What)

viewed(World, Head, Reply, Octets) :-
    view_format(Head, Format),
    view_port(Head, Port),
    findall(Option, view_option(Head, Option), Options),
    view_cut(Head, Format, Cut),
    get_time(T0),
    (   Cut == none
    ->  objects_heard(in_state(World, shown,
                               sg_port:pictured(Options, Format, More,
                                                Octets)),
                      Own),
        state_messages(World, shown, Cutting),
        append(Cutting, Own, Objects)
    ;   objects_heard(in_state(World, loaded,
                               sg_port:cut_made(Cut, Options, Picture,
                                                Names)),
                      Objects),
        cut_pictured(World, Options, Picture, Names, More, Octets)
    ),
    get_time(T1),
    Ms is (T1-T0)*1000,
    atom_string(Format, Kind),
    Reply = More.put(_{port:Port, kind:Kind, messages:Objects, ms:Ms}).

%!  with_picture(+World, +Head:dict, :Goal) is semidet.
%
%   Call Goal once, the current world being World with the picture that Head
%   asks for.
%
%   @error request_error(bad_key(Key, Wanted)), geometry_error(What)

with_picture(World, Head, Goal) :-
    findall(Option, view_option(Head, Option), Options),
    in_state(World, shown, sg_port:looked_at(Options, Goal)).

:- public pictured/4.

pictured(Options, Format, More, Octets) :-
    looked_at(Options, sg_port:formatted(Format, Options, More, Octets)).

:- meta_predicate looked_at(+, 0).

looked_at(Options, Goal) :-
    eye_looks(Options, Others),
    (   member(up(Axis), Others),
        Axis \== z
    ->  with_up(Axis, sg_port:picture_made(Others, Goal))
    ;   picture_made(Others, Goal)
    ).

%   eye_looks(Options, Others): the eye is where Options say; Others say the
%   rest.

eye_looks(Options, Others) :-
    partition(of_eye, Options, Eye, Others),
    maplist(eye_set, Eye),
    segments_there(Others).

of_eye(view(_)).
of_eye(view(_, _, _)).
of_eye(projection(_)).

eye_set(view(Name)) :-
    set_view(Name).
eye_set(view(Theta, Phi, Rho)) :-
    set_view(Theta, Phi, Rho).
eye_set(projection(Kind)) :-
    set_projection(Kind).

segments_there(Options) :-
    (   member(segments(Ss), Options),
        member(S, Ss),
        \+ segment(S, _, _)
    ->  findall(Known, segment(Known, _, _), All),
        request_error(bad_key(segments, no_segment(S, All)))
    ;   true
    ).

:- meta_predicate picture_made(+, 0).

picture_made(Options, Goal) :-
    picture(Options),
    (   drawn(_, _, _, _, _, _, _)
    ->  true
    ;   print_message(informational, sanggwan(nothing_drawn))
    ),
    once(Goal).

:- public formatted/4.

formatted(strokes, Options, More, Octets) :-
    !,
    sheet_strokes(210-148, Options, Sheet, Place, Strokes),
    placed_body(Sheet, Place, Strokes, More0, Octets),
    (   centre(Rho, Near)
    ->  More = More0.put(central, [Rho,Near])
    ;   More = More0
    ).
formatted(mesh, Options, More, Octets) :-
    !,
    open_scene(Scene, Options),
    usual_crease(Usual),
    option(crease(Crease), Options, Usual),
    call_cleanup(scene_mesh(Scene, Crease, point(X,Y,Z),
                            counts(Vertices,Triangles,Lines,Sharp), Octets),
                 scene_close(Scene)),
    More = _{ middle:[X,Y,Z], vertices:Vertices, triangles:Triangles,
              lines:Lines, sharp:Sharp }.
formatted(Format, Options, _{}, Octets) :-
    drawing_format(Format, Type),
    printed_octets(Type, sg_port:drawing_out(Format, Options), Octets).

%   centre(Rho, Near) is semidet: how far the eye is from the origin, and how
%   much farther the nearest vertex is, if the projection is central.

centre(Rho, Near) :-
    current_view(Theta, Phi, Rho, central),
    view_range(Theta, Phi, Near, _, _).

:- public cut_made/4.

cut_made(Cut, Options, Picture, Names) :-
    eye_looks(Options, Others),
    cut_picture(Cut, Others, Picture, Names).

%   cut_pictured(World, Options, Picture, Names, More, Octets): the model cut
%   open or taken apart (port_cut.pl), as strokes, with names of the model.

cut_pictured(World, Options, cut(Sheet,Place,Strokes0,About), Names, More,
             Octets) :-
    (   Names == same
    ->  Strokes = Strokes0
    ;   option(up(Axis), Options, z),
        in_state(World, shown,
                 ( turn_up(Axis), named_strokes(Names, Strokes0, Strokes) ))
    ),
    placed_body(Sheet, Place, Strokes, More0, Octets),
    More = More0.put(About).

placed_body(sheet(Width,Height,_), Place, Strokess, More, Octets) :-
    Place = place(Scale,X,Y,Left,Top),
    all_strokes(Strokess, Strokes),
    strokes_body(Strokes, Looks, Count, Octets),
    More = _{ sheet:[Width,Height], place:[Scale,X,Y,Left,Top],
              looks:Looks, strokes:Count }.

:- public drawing_out/3.

drawing_out(Format, Options, Out) :-
    write_drawing_stream(Format, Out, Options).

%!  strokes_body(+Strokes, -Looks, -Count, -Octets) is det.
%
%   Octets are Strokes (stroke.pl) as stroke_octets/3 has them; Looks are their
%   [Visibility, Role], Count is how many there are.

strokes_body(Strokes, Looks, Count, Octets) :-
    length(Strokes, Count),
    findall(Look, ( member(Stroke, Strokes), stroke_look(Stroke, Look) ),
            Looks0),
    list_to_set(Looks0, Ranked),
    stroke_octets(Ranked, Strokes, Octets),
    maplist(look_json, Ranked, Looks).

%!  drawing_body(+Drawing, -Reply:dict, -Octets) is det.
%
%   Octets are the strokes of Drawing (sheet.pl), Reply has the rest of it.

drawing_body(drawing(sheet(Width,Height,_), Views), Reply, Octets) :-
    findall(Stroke, ( member(view(_, Strokes, _), Views),
                      member(Stroke, Strokes) ),
            All),
    findall([X,Y,High,Anchor,Said],
            ( member(view(_, _, Texts), Views),
              member(text(X,Y,High,Anchor,Said), Texts) ),
            Written),
    strokes_body(All, Looks, Count, Octets),
    Reply = _{ kind:"strokes", sheet:[Width,Height], looks:Looks,
               strokes:Count, texts:Written }.

stroke_look(stroke(Visibility,Role,_,_,_,_,_), look(Visibility,Role,0)).

look_json(look(Visibility,Role,_), [Visibility,Role]).

view_format(Head, Format) :-
    (   get_dict(format, Head, Text)
    ->  (   memberchk(Text, ["strokes","svg","json","pdf","png","dxf","mesh"])
        ->  atom_string(Format, Text)
        ;   request_error(bad_key(format, format))
        )
    ;   Format = svg
    ).

%   view_cut(Head, Format, Cut): Cut is section(Text), explode(Factor) or none.

view_cut(Head, Format, Cut) :-
    findall(Cut0, view_cut_key(Head, Cut0), Cuts),
    (   Cuts == []
    ->  Cut = none
    ;   Cuts = [Cut],
        Format == strokes
    ->  true
    ;   Cuts = [_]
    ->  request_error(bad_key(format, one_of(["strokes"])))
    ;   request_error(bad_key(section, one_cut))
    ).

view_cut_key(Head, section(Text)) :-
    get_dict(section, Head, Text),
    (   string(Text)
    ->  true
    ;   request_error(bad_key(section, section))
    ).
view_cut_key(Head, explode(Factor)) :-
    get_dict(explode, Head, Factor),
    (   number(Factor),
        Factor >= 0,
        Factor =< 100
    ->  true
    ;   request_error(bad_key(explode, factor))
    ).

%   view_option(Head, Option): of the view, of picture/1 and write_drawing/2.

view_option(Head, Option) :-
    get_dict(view, Head, View),
    (   string(View)
    ->  atom_string(Name, View),
        (   named_view(Name, _, _)
        ->  Option = view(Name)
        ;   findall(Known, named_view(Known, _, _), All),
            near_words(Name, All, Near),
            request_error(bad_key(view, no_view(Name, Near, All)))
        )
    ;   View = [Theta,Phi],
        number(Theta),
        number(Phi)
    ->  Option = view(Theta, Phi, 0)
    ;   View = [Theta,Phi,Rho],
        number(Theta),
        number(Phi),
        number(Rho),
        Rho >= 0
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
view_option(Head, Option) :-
    member(Key, [scale,margin]),
    get_dict(Key, Head, Number),
    (   number(Number),
        Number > 0,
        Number < 1.0e9
    ->  Option =.. [Key,Number]
    ;   request_error(bad_key(Key, positive))
    ).
view_option(Head, size(W-H)) :-
    get_dict(size, Head, Size),
    (   Size = [W,H],
        number(W),
        number(H),
        min(W, H) >= 0.001,
        max(W, H) =< 100 000
    ->  true
    ;   request_error(bad_key(size, size))
    ).
view_option(Head, segments(Segments)) :-
    get_dict(segments, Head, Segments),
    (   is_list(Segments),
        forall(member(S, Segments), integer(S))
    ->  true
    ;   request_error(bad_key(segments, segments))
    ).
