:- module(test_stroke_picture, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(dcg/basics)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(rules(drawing/drawing)).
:- use_module(rules(drawing/travel)).
:- use_module(rules(picture/hidden_lines), except([lies_on/4])).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(sheet/sheet)).
:- use_module(rules(store), except([piece/3])).
:- use_module(rules(sheet/stroke)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(picture/view)).
:- use_module(tests('golden/goldens')).
:- use_module(tests('rules/random_solid')).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).
:- use_module(tests('oracle/stroke')).
:- use_module(tests('rules/sample')).

/* Strokes of whole pictures: what is drawn is what drawn/7 has, all of it and
   nothing else; nothing is drawn twice, in random scenes and in the goldens. */

% Three solids from random sides; half of them on a grid, seen squarely.
scene(Seed) :-
    set_random(seed(Seed)),
    forall(between(1, 3, _),
           ( (   Seed mod 2 =:= 0
             ->  random_blocks(_, Primitive)
             ;   random_placed(Primitive)
             ),
             add_primitive(Primitive, _) )),
    complete_segments,
    penetrate,
    (   Seed mod 4 =:= 0
    ->  random_member(View, [front,top,left,iso]),
        set_view(View)
    ;   Theta is 360*random_float,
        Phi is 180*random_float,
        set_view(Theta, Phi, 0)
    ),
    random_member(Which, [all,feature]),
    picture([lines(Which)]).

% In millionths of the picture's unit.
scene_strokes(Parts, Strokes) :-
    picture_parts(Parts0),
    maplist(rounded, Parts0, Parts),
    strokes(Parts, Strokes).

rounded(part(V,R,S,E,F,T,XA-YA,XB-YB), part(V,R,S,E,F,T,A1-A2,B1-B2)) :-
    A1 is round(XA*1.0e6),
    A2 is round(YA*1.0e6),
    B1 is round(XB*1.0e6),
    B2 is round(YB*1.0e6).

ends_of_parts(Parts, Ends) :-
    findall(L-H, ( member(part(_,_,_,_,_,_,A,B), Parts), A \== B,
                   msort([A,B], [L,H]) ), Ends0),
    sort(Ends0, Ends).

% The straight pieces of strokes.
pieces(Strokes, Pieces) :-
    findall(A-B, ( member(stroke(_,_,_,_,Points,_,_), Strokes),
                   piece(Points, A, B) ), Pieces).

piece([A,B|_], A, B).
piece([_|Points], A, B) :-
    piece(Points, A, B).

ends_of_strokes(Strokes, Ends) :-
    pieces(Strokes, Pieces),
    findall(L-H, ( member(A-B, Pieces), msort([A,B], [L,H]) ), Ends0),
    msort(Ends0, Ends).

% Two pieces of which more than Least lie on one another, nearer than Near; not
% those that leave one point.
doubled(Pieces, Near, Least, P-Q) :-
    findall(Low-box(High,Y1,Y2,A-B),
            ( member(A-B, Pieces),
              A = XA-YA,
              B = XB-YB,
              Low is min(XA,XB)-Near, High is max(XA,XB)+Near,
              Y1 is min(YA,YB)-Near, Y2 is max(YA,YB)+Near ),
            Boxes0),
    keysort(Boxes0, Boxes),
    append(_, [_-box(High,Y1,Y2,P)|Rest], Boxes),
    near_box(Rest, High, Y1, Y2, Q),
    \+ share_end(P, Q),
    (   lies_on(P, Q, Near, Least)
    ;   lies_on(Q, P, Near, Least)
    ),
    !.

share_end(A-B, C-D) :-
    once(( member(X, [A,B]), member(X, [C,D]) )),
    msort([A,B], AB),
    \+ msort([C,D], AB).

near_box([Low-box(_,Z1,Z2,Q0)|Rest], High, Y1, Y2, Q) :-
    Low =< High,
    (   Z1 =< Y2,
        Y1 =< Z2,
        Q = Q0
    ;   near_box(Rest, High, Y1, Y2, Q)
    ).

lies_on((XA-YA)-(XB-YB), (XC-YC)-(XD-YD), Near, Least) :-
    DX is XB-XA,
    DY is YB-YA,
    L is sqrt(DX*DX+DY*DY),
    abs(DX*(YC-YA)-DY*(XC-XA)) =< Near*L,
    abs(DX*(YD-YA)-DY*(XD-XA)) =< Near*L,
    C is (DX*(XC-XA)+DY*(YC-YA))/L,
    D is (DX*(XD-XA)+DY*(YD-YA))/L,
    min(max(C,D), L) - max(min(C,D), 0) > Least.

% The pieces of a golden drawing, in thousandths; those of edges, for an outline
% inside triangles may come as near to a crease as it likes.
golden_pieces(Name, Pieces) :-
    golden_file(Name, File),
    read_file_to_codes(File, Codes, [encoding(utf8)]),
    phrase(polylines(Lines), Codes),
    findall(A-B, ( member(Points, Lines), piece(Points, A, B) ), Pieces).

polylines(Lines) -->
    string(_), " data-edge=\"", string_without(`"`, Edges), string(_),
    " points=\"",
    !,
    points(Points),
    { memberchk(0'-, Edges)
    ->  Lines = Lines1
    ;   Lines = [Points|Lines1]
    },
    polylines(Lines1).
polylines([]) -->
    remainder(_).

points([X-Y|Points]) -->
    thousandths(X), ",", thousandths(Y),
    (   " "
    ->  points(Points)
    ;   { Points = [] }
    ).

thousandths(N) -->
    number(X),
    { N is round(X*1000) }.

:- begin_tests(stroke_picture).

% The kernel does with rows what the rule does with parts.
test(kernel_is_rule, [ forall(( numbered(20, 60, Seed),
                                Options = [hidden(Hidden)],
                                nth0(K, [dashed,removed,shown], Hidden),
                                K =:= Seed mod 3 )),
                       Sheet1-Strokes1 == Sheet2-Strokes2 ]) :-
    new_world(World),
    in_world(World, ( scene(Seed),
                      sheet_strokes(210-148, Options, Sheet1, _, Strokess),
                      all_strokes(Strokess, Strokes1),
                      sheet_strokes_by_rule(210-148, Options, Sheet2,
                                            Strokes2) )).
test(kernel_of_nothing, Strokes == []) :-
    new_world(World),
    in_world(World, sheet_strokes(210-148, [], _, _, Strokes)).

test(all_and_nothing_else, [forall(numbered(15, 40, Seed))]) :-
    in_new_world(( scene(Seed), scene_strokes(Parts, Strokes) )),
    ends_of_parts(Parts, Wanted),
    ends_of_strokes(Strokes, Drawn),
    assertion(Seed-Drawn == Seed-Wanted).
test(kernel_is_rule, [forall(numbered(15, 40, Seed))]) :-
    in_new_world(( scene(Seed), scene_strokes(Parts, Kernel) )),
    strokes_by_rule(Parts, Rule),
    assertion(Seed-Kernel == Seed-Rule).
test(nothing_twice, [forall(numbered(15, 40, Seed))]) :-
    in_new_world(( scene(Seed), scene_strokes(_, Strokes) )),
    pieces(Strokes, Pieces),
    findall(Pair, doubled(Pieces, 2, 1000, Pair), Pairs),
    assertion(Seed-Pairs == Seed-[]).
test(no_golden_twice, [forall(golden(Name, _))]) :-
    golden_pieces(Name, Pieces),
    findall(Pair, doubled(Pieces, 1, 400, Pair), Pairs),
    assertion(Name-Pairs == Name-[]).

:- end_tests(stroke_picture).

% A picture of many lines takes little of the stacks: no part is a term, and
% no writer copies the strokes.

:- begin_tests(little_room).

test(formats, [ condition(current_prolog_flag(threads, true)),
                Failed-Rule == []-resource_error ]) :-
    new_world(World),
    in_world(World,
             ( add_primitive(sphere(radius(1), facets(80), bands(40)), _),
               complete_segments,
               picture([lines(all)]),
               findall(Format-Status, failed_in(2 500 000, Format, Status),
                       Failed),
               within_stack(2 500 000,
                            sheet_strokes_by_rule(210-148, [], _, _),
                            exception(error(Error, _))),
               functor(Error, Rule, _) )).

% Lines behind strips: strokes are terms a thousand at a time.

test(strips, [ condition(current_prolog_flag(threads, true)),
               Failed-Single == []-resource_error ]) :-
    new_world(World),
    in_world(World,
             ( lines_behind_strips(100, 100),
               findall(Format-Status,
                       failed_in([svg,pdf,eps,ps,dxf,hpgl,json], 3 500 000,
                                 Format, Status),
                       Failed),
               within_stack(3 500 000, single_sheet_strokes,
                            exception(error(Error, _))),
               functor(Error, Single, _) )).

% More strokes of one segment than are terms at a time.

test(many_of_one_segment, Run-Drawn == Single-DrawnSingle) :-
    new_world(World),
    in_world(World,
             ( lines_behind_strips(1, 1100),
               sheet_strokes(210-148, [], _, _, Strokess),
               all_strokes(Strokess, Run),
               sheet_strokes_by_rule(210-148, [], _, Single) )),
    drawn_numbers(Strokess, Drawn),
    drawn_numbers(Single, DrawnSingle).

%   lines_behind_strips(Lines, Strips): seen from the front.

lines_behind_strips(Lines, Strips) :-
    forall(between(1, Lines, I),
           ( Z is I/Lines,
             add_primitive(line(from(0,1,Z), to(1,1,Z)), _) )),
    Width is 0.5/Strips,
    forall(between(1, Strips, I),
           ( X is I/(Strips+1),
             add_primitive(at([rotate(x,90),translate(X,0,1)],
                              rectangle(size(Width,4))), _) )),
    complete_segments,
    set_view(front),
    picture([lines(all)]).

single_sheet_strokes :-
    sheet_strokes(210-148, [], _, _, Strokess),
    all_strokes(Strokess, _).

%   drawn_numbers(Strokess, Strokes): as a pen draws them.

drawn_numbers(Strokess, Strokes) :-
    travel(0-148000, short, Strokess, Travel),
    fold_travel(listed, Travel, Strokes, []).

listed(Stroke, [Stroke|Strokes], Strokes).

failed_in(Bytes, Format, Status) :-
    failed_in([svg,pdf,eps,ps,png,dxf,hpgl,json,pl], Bytes, Format, Status).

failed_in(Formats, Bytes, Format, Status) :-
    member(Format, Formats),
    within_stack(Bytes, written_to_nothing(Format), Status),
    Status \== true.

%   within_stack(+Bytes, :Goal, -Status): of a thread that has no more room.

within_stack(Bytes, Goal, Status) :-
    current_world(World),
    thread_create(in_world(World, Goal), Thread, [stack_limit(Bytes)]),
    thread_join(Thread, Status).

written_to_nothing(Format) :-
    setup_call_cleanup(
        open_null_stream(Out),
        write_drawing_stream(Format, Out, []),
        close(Out)).

:- end_tests(little_room).
