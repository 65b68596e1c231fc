:- module(sg_test_picture_checked,
          [ open_pictures/1,            % -Pictures
            cut_all/1,                  % +Options
            drawn_lengths/2,            % -Visible, -Hidden
            add_picture/4,              % +Pictures, +Name, +View, :Build
            add_drawing/2,              % +Pictures, +Name
            check_pictures/2,           % +Pictures, -Results
            looked_from/1,              % +View
            view_rows/2,                % +View, -Rows
            bad_picture/2               % +Result, -Fault
          ]).
/** <module> The independent checker of pictures, from Prolog.

The program is tests/picture_checker, which shares nothing with the engine. It
gets the triangles as they were before anything was cut, the lines with their
exact ends, and what was drawn.
*/

:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(dcg/basics)).
:- use_module(library(lists)).
:- use_module(library(process)).
:- use_module(library(pure_input)).
:- use_module(rules(picture/contour), [line_ends/4]).
:- use_module(rules(exact)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(picture/view)).

:- meta_predicate add_picture(+, +, +, 0).

%!  open_pictures(-Pictures) is det.
%
%   Begin a heap of pictures, to be checked all at once.

open_pictures(pictures(File, Out)) :-
    tmp_file_stream(File, Out, [extension(txt), encoding(utf8)]).

%!  add_picture(+Pictures, +Name, +View, :Build) is det.
%
%   In a new world, Build a scene, cut its segments by each other and by
%   themselves, draw all its lines as seen in View (see looked_from/1), and add
%   the picture to Pictures as Name, an atom without spaces.

add_picture(pictures(_, Out), Name, View, Build) :-
    new_world(World),
    in_world(World,
             ( once(Build),
               findall(Triangle, model_triangle(Triangle), Triangles),
               cut_all([]),
               looked_from(View),
               picture([lines(all)]),
               view_rows(View, Rows),
               write_scene(Out, Name, Rows, Triangles) )).

%!  add_drawing(+Pictures, +Name) is det.
%
%   Add what is drawn in the current world, as lines of the picture with nothing
%   before them: for the checker to say if anything is drawn twice.

add_drawing(pictures(_, Out), Name) :-
    write_view(parallel([1,0,0, 0,1,0, 0,0,1]), Out),
    findall(S-E, drawn(_, S, E, _, _, _, _), Lines0),
    sort(Lines0, Lines),
    forall(member(S-E, Lines),
           ( line_ends(S, E, X0-Y0, X1-Y1),
             format(Out, "l ~d ~d", [S,E]),
             write_numbers(Out, [X0,Y0,0,X1,Y1,0]) )),
    forall(drawn(_, S, E, From, To, _, _),
           ( format(Out, "d ~d ~d", [S,E]),
             write_number(Out, From),
             write_number(Out, To),
             format(Out, " visible~n", []) )),
    format(Out, "end ~w~n", [Name]).

%!  cut_all(+Options) is det.
%
%   Every segment of the current world is cut by every other and by itself.
%   Options as of penetrate/2.

cut_all(Options) :-
    findall(S-T, ( segment(S, _, _), segment(T, _, _), S =< T ), Pairs),
    penetrate(Pairs, Options).

%!  drawn_lengths(-Visible, -Hidden) is det.
%
%   How long in the picture is all that is drawn as visible, and as hidden.

drawn_lengths(Visible, Hidden) :-
    aggregate_all(r(sum(V),sum(H)), drawn_length(V, H), r(Visible,Hidden)).

drawn_length(V, H) :-
    drawn(_, S, E, From, To, Visibility, _),
    e(S, E, A, B, _),
    screen(S, A, X0, Y0, _),
    screen(S, B, X1, Y1, _),
    Length is (To-From)*sqrt((X1-X0)**2+(Y1-Y0)**2),
    (   Visibility == visible
    ->  V = Length,
        H = 0
    ;   V = 0,
        H = Length
    ).

model_triangle([X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3]) :-
    t(S, _, _, A, B, C),
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    v(S, C, X3, Y3, Z3).

                /*******************************
                *             VIEWS            *
                *******************************/

%!  looked_from(+View) is det.
%
%   Set the view of the current world: a name, direction(X,Y,Z), whole numbers,
%   from the origin to the eye, angles(Theta,Phi), central(Theta,Phi,Rho), or
%   central(Name,Rho).

looked_from(direction(X,Y,Z)) :-
    !,
    set_direction(X, Y, Z).
looked_from(angles(Theta,Phi)) :-
    !,
    set_view(Theta, Phi, 0).
looked_from(central(Theta,Phi,Rho)) :-
    !,
    set_view(Theta, Phi, Rho),
    set_projection(central).
looked_from(central(Name,Rho)) :-
    !,
    named_view(Name, Theta, Phi),
    looked_from(central(Theta,Phi,Rho)).
looked_from(Name) :-
    set_view(Name).

%!  view_rows(+View, -Rows) is det.
%
%   Rows is what the checker is told: parallel(Rows) or central(Rows,Rho); Rows
%   are nine rationals, to the right, up and away. Where the picture is meant to
%   be square with something, whole numbers instead of unit vectors.

view_rows(direction(X,Y,Z), parallel(Rows)) :-
    (   X =:= 0,
        Y =:= 0
    ->  Up is sign(Z),
        Away is -Up,
        Rows = [1,0,0, 0,Up,0, 0,0,Away]
    ;   A is -Y,
        B is -X*Z,
        C is -Y*Z,
        D is X*X+Y*Y,
        maplist([P,Q]>>(Q is -P), [X,Y,Z], [E,F,G]),
        Rows = [A,X,0, B,C,D, E,F,G]
    ).
view_rows(angles(Theta,Phi), parallel(Rows)) :-
    rounded_rows(Theta, Phi, Rows).
view_rows(central(Theta,Phi,Rho0), central(Rows,Rho)) :-
    rounded_rows(Theta, Phi, Rows),
    Rho is rational(Rho0).
view_rows(central(Name,Rho), central(Rows,Rho)) :-
    view_rows(Name, parallel(Rows)).
view_rows(front,  parallel([ 1, 0,0,  0, 0,1,  0, 1, 0])).
view_rows(right,  parallel([ 0, 1,0,  0, 0,1, -1, 0, 0])).
view_rows(top,    parallel([ 1, 0,0,  0, 1,0,  0, 0,-1])).
view_rows(left,   parallel([ 0,-1,0,  0, 0,1,  1, 0, 0])).
view_rows(back,   parallel([-1, 0,0,  0, 0,1,  0,-1, 0])).
view_rows(bottom, parallel([ 1, 0,0,  0,-1,0,  0, 0, 1])).
view_rows(iso, Rows) :-
    view_rows(direction(1,-1,1), Rows).

%   The rows of PL-11, each number rounded to 30 bits after the point.

rounded_rows(Theta, Phi, Rows) :-
    T is Theta*pi/180,
    P is Phi*pi/180,
    St is sin(T),
    Ct is cos(T),
    Sp is sin(P),
    Cp is cos(P),
    maplist(rounded,
            [-St,Ct,0, -Ct*Cp,-St*Cp,Sp, -Sp*Ct,-St*Sp,-Cp],
            Rows).

rounded(Expression, Number) :-
    Number is round(Expression*2**30) rdiv 2**30.

                /*******************************
                *            SCENES            *
                *******************************/

write_scene(Out, Name, Rows, Triangles) :-
    write_view(Rows, Out),
    forall(member(Numbers, Triangles), write_item(Out, t, Numbers)),
    findall(Line, real_line(Line), Lines),
    forall(member(line(S,E,Numbers), Lines),
           ( format(Out, "l ~d ~d", [S,E]),
             write_numbers(Out, Numbers) )),
    forall(drawn(_, S, E, From, To, Visibility, _),
           ( format(Out, "d ~d ~d", [S,E]),
             write_number(Out, From),
             write_number(Out, To),
             format(Out, " ~w~n", [Visibility]) )),
    format(Out, "end ~w~n", [Name]).

write_view(parallel(Rows), Out) :-
    write_item(Out, parallel, Rows).
write_view(central(Rows,Rho), Out) :-
    append(Rows, [Rho], Numbers),
    write_item(Out, central, Numbers).

write_item(Out, Word, Numbers) :-
    write(Out, Word),
    write_numbers(Out, Numbers).

write_numbers(Out, Numbers) :-
    forall(member(X, Numbers), write_number(Out, X)),
    nl(Out).

write_number(Out, X) :-
    Y is rational(X),
    rational(Y, N, D),
    format(Out, " ~d/~d", [N,D]).

%   Of the real edges between two vertices the one with the smallest number.

real_line(line(S,E,Ends)) :-
    segment(S, _, _),
    findall(A-B-E0,
            ( e(S, E0, V1, V2, 1), A is min(V1, V2), B is max(V1, V2) ),
            Edges0),
    sort(Edges0, Edges),
    aggregate_all(bag(A-B-First),
                  aggregate(min(E0), member(A-B-E0, Edges), First),
                  Firsts),
    member(_-_-E, Firsts),
    e(S, E, From, To, _),
    once(place(S, From, X1, Y1, Z1)),
    once(place(S, To, X2, Y2, Z2)),
    Ends = [X1,Y1,Z1,X2,Y2,Z2].

%   Where the operands of a Boolean are gone, its result is what v/5 has.

place(S, V, X, Y, Z) :-
    catch(vertex_exact(S, V, X, Y, Z), error(existence_error(_, _), _), fail).
place(S, V, X, Y, Z) :-
    v(S, V, X, Y, Z).

                /*******************************
                *            RESULTS           *
                *******************************/

%!  check_pictures(+Pictures, -Results) is det.
%
%   Results are what the checker says of each picture that was added: a dict
%   with its name and the numbers that tests/picture_checker lists.

check_pictures(pictures(File, Out), Results) :-
    close(Out),
    absolute_file_name(foreign('tests/picture_checker'), Program,
                       [access(execute)]),
    setup_call_cleanup(
        process_create(Program, [File],
                       [stdout(pipe(Said)), process(Pid)]),
        phrase_from_stream(results(Results), Said),
        ( close(Said),
          process_wait(Pid, Status)
        )),
    Status == exit(0),
    delete_file(File).

results([Result|Results]) -->
    string_without(`:\n`, Codes),
    ": ",
    !,
    { atom_codes(Name, Codes) },
    words(Pairs),
    "\n",
    { dict_pairs(Result, picture, [name-Name|Pairs]) },
    results(Results).
results([]) -->
    eos.

words([Key-Value|Words]) -->
    string_without(`=\n`, Codes),
    "=",
    number(Value),
    { atom_codes(Key, Codes) },
    (   " "
    ->  words(Words)
    ;   { Words = [] }
    ).

%!  bad_picture(+Result, -Fault) is semidet.
%
%   Fault is what is wrong with a picture: a part drawn as what it is not, a
%   part lost or drawn twice, or a length that is not as it should be.

bad_picture(Result, Fault) :-
    Most is 1.0e-6*(1+Result.lines/100)*max(1, Result.size),
    (   Result.wrong > Most
    ->  Fault = wrong(Result.wrong)
    ;   Result.lost > Most
    ->  Fault = lost(Result.lost)
    ;   Result.twice > 10*Most
    ->  Fault = twice(Result.twice)
    ;   abs(Result.visible-Result.drawn_visible) > 10*Most
    ->  Fault = visible(Result.visible, Result.drawn_visible)
    ;   abs(Result.hidden-Result.drawn_hidden) > 10*Most
    ->  Fault = hidden(Result.hidden, Result.drawn_hidden)
    ).
