:- module(sg_pattern_tab,
          [ piece_shapes/3,             % +Width, +Piece, -Named
            tabs/5,                     % +Width, +On, +Pieces, -Tabs, -Butt
            butt_reasons/4,             % +Width, +Pieces, +Butt, -Whys
            least_tab/2,                % +Width, -Least
            deepest_tab/3,              % +Width, +Pieces, -Deep
            side_length/2,              % +Side, -Length
            tab_shape/4                 % +Width, +Length, -Shape, -Area
          ]).
:- use_module('../near', [tolerance/2, less_part/2]).
:- use_module('../kernel', [shapes_add/2, shapes_free/3, shapes_open/2]).
:- use_module('../decision', [decision/2, default/1]).
:- use_module(pattern_outline, [cut_loops/2, loop_area/2]).
:- use_module(pattern_strip, [seam_runs/3, strip_form/5]).
:- use_module(pattern_trim, [trimmed_tab/4]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), 
              [ append/2, append/3, last/2, max_list/2, member/2, nth1/3,
                reverse/2 ]).
:- use_module(library(pairs), 
              [group_pairs_by_key/2, pairs_keys_values/3, pairs_values/2]).
/** <module> Tabs: what the two sides of a seam are glued with.

One side of a seam gets a tab, a trapezoid that stands on it. Of both sides and
of the forms of tab_shape/4 the largest is taken that lies on no face and on no
other tab of its piece. Where that is less than half of what there would be in
the open, the largest form is trimmed, as with scissors, to what is free beside
the seam (pattern_trim.pl), if that leaves more. What remains of a seam gets
tabs of its own, on whichever side has room. Before all others the facets of
curves have tabs together (pattern_strip.pl). Where nothing fits that is as
large as least_tab/2 says, the seam is a butt joint.

Places along a seam are in millimetres from its start on its first side.
*/

:- set_prolog_flag(optimise, true).

% How deep a tab may lie in a face, in millimetres.
touching(Near) :-
    tolerance(paper, Near).

% So many tabs a seam has at most, one beside the other.
most_tabs(3).

%!  least_tab(+Width, -Least) is det.
%
%   Least is how deep a tab is, in the middle, where tabs should be Width deep:
%   1 mm, or a third of Width. Along the seam it is at least twice that.

least_tab(Width, Least) :-
    Least is min(1.0, Width/3).

%!  deepest_tab(+Width, +Pieces, -Deep) is det.
%
%   Deep is how deep the tabs of Pieces may be that should be Width deep: less
%   than Width if all seams are short.

deepest_tab(Width, Pieces, Deep) :-
    findall(Length,
            ( seam_side(Pieces, _, _, Side), side_length(Side, Length) ),
            Lengths),
    max_list([0.0|Lengths], Longest),
    Deep is min(Width, 0.45*Longest).

%!  tabs(+Width, +On, +Pieces, -Tabs, -Butt) is det.
%
%   On is `one`, the side of each seam that has more room; `both`; or
%   `alternate`: of seams that follow each other round a piece one side and the
%   other in turn, as far as there is room, so that the tabs of two pieces mesh.
%   The facets of a curve have their tab on one side, or both.
%
%   Tabs are tab(D,E,A,B)-What: on side E from vertex A to vertex B, at most
%   Width deep. What is a list of outlines, each a list of points in the order
%   of the outline of the piece, as they follow each other; or strip(Points),
%   the part that belongs to this side of a tab that it shares with its
%   neighbours, which goes on where that of the side before ended. Butt lists
%   the seams D-J that have none, as (D-J)-E, E the edge on their first side.

tabs(Width, On, Pieces, Tabs, Butt) :-
    maplist(piece_shapes(Width), Pieces, Named),
    list_to_assoc(Named, Shapes),
    findall(Seam-(Name-Side), seam_side(Pieces, Seam, Name, Side), Sides0),
    keysort(Sides0, Sides),
    findall(k(Name,J,Which)-Side, side_key(Sides, Name, J, Which, Side), Keys0),
    sort(1, @<, Keys0, Keys1),
    list_to_assoc(Keys1, Keys),
    seam_runs(Width, Pieces, Runs),
    foldl(run_tabs(On, Width, Shapes, Keys), Runs, Strips-Served0, []-[]),
    sort(1, @<, Served0, Served1),
    list_to_assoc(Served1, Served),
    group_pairs_by_key(Sides, Seams0),
    findall(Rank-Seam,
            ( member((D-J)-Own, Seams0),
              \+ get_assoc(D-J, Served, _),
              one_to_one(Own, Some),
              seam_rank((D-J)-Some, Rank-Seam)
            ),
            Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Seams),
    wanted_sides(On, Pieces, Wanted),
    foldl(seam_tabs(Wanted, Width, Shapes), Seams, Tabs0-Butt0, []-[]),
    append(Strips, Tabs0, Tabs),
    sort(1, @<, Butt0, Butt).

%!  butt_reasons(+Width, +Pieces, +Butt, -Whys) is det.
%
%   Whys are Why-(D-J) for the seams of Butt, an assoc with keys D-J: `short`,
%   too short for a tab; `slit`, the faces beside it leave no room on either
%   side; or `taken`, other tabs do.

butt_reasons(Width, Pieces, Butt, Whys) :-
    maplist(piece_shapes(Width), Pieces, Named),
    list_to_assoc(Named, Shapes),
    findall(Seam-(Name-Side),
            ( seam_side(Pieces, Seam, Name, Side),
              get_assoc(Seam, Butt, _)
            ),
            Sides0),
    keysort(Sides0, Sides),
    group_pairs_by_key(Sides, Seams),
    findall(Why-Seam,
            ( member(Seam-Own, Seams), butt_reason(Width, Shapes, Own, Why) ),
            Whys).

butt_reason(Width, Shapes, Sides, Why) :-
    Sides = [_-Side|_],
    side_length(Side, Length),
    (   \+ tab_shape(Width, Length, _, _)
    ->  Why = short
    ;   member(Some, Sides),
        glue_side(Shapes, Some, Glue),
        best_tab(0.0, Length, part(Length,Width,[Glue]), _)
    ->  Why = taken
    ;   Why = slit
    ).

seam_side(Pieces, D-J, Name, Side) :-
    member(piece(Name,_,Sides), Pieces),
    Name = name(D, _, _),
    member(Side, Sides),
    Side = side(_, _, _, _, seam(J,_,_)).

side_key(Sides, Name, J, Which, Side) :-
    member(_-(Name-Side), Sides),
    Side = side(_, _, _, _, seam(J,_,Which)).

%   one_to_one(Sides0, Sides) is nondet: where a face was divided a seam has
%   several parts on one side, not the same as on the other. Then each part of
%   the first has a tab, if it has room.

one_to_one(Sides0, Sides) :-
    (   Sides0 = [_,_,_|_]
    ->  member(Side, Sides0),
        Side = _-side(_, _, _, _, seam(_,_,1)),
        Sides = [Side]
    ;   Sides = Sides0
    ).

%   Long seams choose first, for they hold the most.

seam_rank(Seam-Sides, Rank-(Seam-Sides)) :-
    Sides = [_-Side|_],
    side_length(Side, Length),
    Rank is -round(Length*1000).

%!  side_length(+Side, -Length) is det.
%
%   Length, in millimetres, is that of a side as in pattern_piece.pl.

side_length(side(_,_,_-A,_-B,_), Length) :-
    points_apart(A, B, Length).

points_apart(XA-YA, XB-YB, Length) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2).

%!  piece_shapes(+Width, +Piece, -Named) is det.
%
%   Named is Name-Shapes, the name of Piece and a handle with its faces, on
%   which nothing that is Width deep may lie (shapes_add/2).

piece_shapes(Width, piece(Name,Faces,_), Name-Shapes) :-
    Cell is max(Width, 0.1),
    findall(Shape,
            ( member(face(_,Corners), Faces), member(Shape, Corners) ),
            Solid),
    shapes_cell(Solid, Cell, Side),
    shapes_open(Side, Shapes),
    forall(member(Corners, Solid),
           ( maplist(corner_point, Corners, Points),
             shapes_add(Shapes, Points)
           )).

corner_point(_-Point, Point).

%   About as large as a face.

shapes_cell(Solid, Least, Cell) :-
    foldl(wider, Solid, 0-0.0, N-Sum),
    Cell is max(Least, Sum/max(1, N)).

wider([_-(XA-YA),_-(XB-YB)|_], N0-Sum0, N-Sum) :-
    N is N0+1,
    Sum is Sum0 + max(abs(XB-XA), abs(YB-YA)).



                /*******************************
                *            CURVES            *
                *******************************/

%   One tab for the seams of a run, on the side where there is room; if there is
%   none on either, each seam is on its own.

run_tabs(On, Width, Shapes, Sides, Run, Tabs0-Served0, Tabs-Served) :-
    pairs_keys_values(Run, Keys, Partners0),
    reverse(Partners0, Partners),
    How = strips(Width, Shapes, Sides),
    (   On == both
    ->  run_strip(How, [Keys], Tabs0-Served0, Tabs1-Served1),
        run_strip(How, [Partners], Tabs1-Served1, Tabs-Served)
    ;   run_strip(How, [Keys,Partners], Tabs0-Served0, Tabs-Served)
    ).

%   run_strip(How, Owns, Tabs0-Served0, Tabs-Served): on the first of Owns that
%   has room.

run_strip(strips(Width,Shapes,Sides), Owns, Tabs0-Served0, Tabs-Served) :-
    least_tab(Width, Least),
    (   member(Own, Owns),
        maplist(key_side(Sides), Own, OwnSides),
        Own = [k(Name,_,_)|_],
        get_assoc(Name, Shapes, Piece),
        strip_on(OwnSides, Width, Least, Piece, Outline)
    ->  Name = name(D, _, _),
        strip_tabs(OwnSides, D, Outline, Tabs0, Tabs),
        findall((D-J)-strip, member(k(_,J,_), Own), New),
        append(New, Served, Served0)
    ;   Tabs0 = Tabs,
        Served0 = Served
    ).

key_side(Sides, Key, Side) :-
    get_assoc(Key, Sides, Side).

strip_on(Sides, Width, Least, Piece, Outline) :-
    Sides = [side(_,_,_-First,_,_)|_],
    findall(B, member(side(_,_,_,_-B,_), Sides), Ends),
    last(Ends, Last),
    points_apart(First, Last, Chord),
    findall(Area-Deep,
            tab_shape(Width, Chord, tab(_,_,_,_,Deep), Area),
            Forms),
    keysort(Forms, Sorted),
    last(Sorted, _-Deepest),
    touching(Tolerance),
    strip_form([First|Ends], Deepest, Least, strip(Outline,Cells), _),
    \+ ( member(Cell, Cells), \+ shapes_free(Piece, Cell, Tolerance) ),
    !,
    forall(member(Cell, Cells), shapes_add(Piece, Cell)).

%   Each side has its part of the outline.

strip_tabs([Side|Sides], D, [P,T,Q|Points], [Tab|Tabs0], Tabs) :-
    strip_tab(D, Side, [P,T,Q], Tab),
    rest_of_strip(Sides, D, [Q|Points], Tabs0, Tabs).

rest_of_strip([Side], D, Points, [Tab|Tabs], Tabs) :-
    !,
    strip_tab(D, Side, Points, Tab).
rest_of_strip([Side|Sides], D, [P,Q|Points], [Tab|Tabs0], Tabs) :-
    strip_tab(D, Side, [P,Q], Tab),
    rest_of_strip(Sides, D, [Q|Points], Tabs0, Tabs).

strip_tab(D, side(E,_,A-_,B-_,_), Points, tab(D,E,A,B)-strip(Points)).


                /*******************************
                *           ONE SEAM           *
                *******************************/

seam_tabs(Wanted, Width, Shapes, (D-J)-Sides, Tabs0-Butt0, Tabs-Butt) :-
    maplist(glue_side(Shapes), Sides, Glues),
    Sides = [_-First|_],
    side_length(First, Length),
    glues_in_turn(Wanted, D-J, Glues, Turns),
    turns_placed(Turns, Length, Width, Placed0),
    keysort(Placed0, Placed),
    group_pairs_by_key(Placed, BySide),
    (   BySide == []
    ->  First = side(E, _, _, _, _),
        Tabs0 = Tabs,
        Butt0 = [(D-J)-E|Butt]
    ;   findall(Tab, ( member(By, BySide), side_tabs(D, Sides, By, Tab) ), New),
        append(New, Tabs, Tabs0),
        Butt0 = Butt
    ).

%   wanted_sides(On, Pieces, Wanted): Wanted is `one`, `both`, or an assoc from
%   seams D-J to the side that should have the tab: their places round the piece
%   of the first side are odd or even.

wanted_sides(alternate, Pieces, Wanted) :-
    !,
    findall((D-J)-Which,
            ( member(piece(name(D,_,_),_,Sides), Pieces),
              cut_loops(Sides, Loops),
              member(Loop, Loops),
              nth1(I, Loop, side(_,_,_,_,seam(J,_,1))),
              Which is 1 + I mod 2
            ),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Wanted).
wanted_sides(On, _, On).

%   glues_in_turn(Wanted, Seam, Glues, Turns): Turns are all(Lists) if each of
%   Lists of sides is to have tabs, or first(Lists): the first that has room.

glues_in_turn(one, _, Glues, first([Glues])) :-
    !.
glues_in_turn(both, _, Glues, all(Lists)) :-
    !,
    findall(One, one_glue(Glues, _, One), Lists).
glues_in_turn(Wanted, Seam, Glues, first(Lists)) :-
    (   get_assoc(Seam, Wanted, Which),
        one_glue(Glues, Which, One)
    ->  Lists = [One,Glues]
    ;   Lists = [Glues]
    ).

one_glue([Glue|_], 1, [Glue]).
one_glue([_,Glue|_], 2, [none,Glue]).

turns_placed(first(Lists), Length, Width, Placed) :-
    (   member(Glues, Lists),
        glues_placed(Length, Width, Glues, Placed),
        Placed \== []
    ->  true
    ;   Placed = []
    ).
turns_placed(all(Lists), Length, Width, Placed) :-
    maplist(glues_placed(Length, Width), Lists, Placeds),
    append(Placeds, Placed).

glues_placed(Length, Width, Glues, Placed) :-
    most_tabs(Most),
    placed_between(0.0, Length, part(Length,Width,Glues), Most, Placed, []).

%   A side that may have tabs, and all that is in its piece.

glue_side(Shapes, Name-Side, glue(Side,Own)) :-
    get_assoc(Name, Shapes, Own).

%   The second side runs back along the first one.

side_tabs(D, [_-Side|_], 1-Outlines, tab(D,E,A,B)-Outlines) :-
    Side = side(E, _, A-_, B-_, _).
side_tabs(D, [_,_-Side|_], 2-Outlines0, tab(D,E,A,B)-Outlines) :-
    Side = side(E, _, A-_, B-_, _),
    reverse(Outlines0, Outlines).

%   placed_between(From, To, part(Length,Width,Glues), Most, Placed0, Placed):
%   Which-Outline for each tab between two places on the seam, in order; Which
%   is the side. At most Most of them.

placed_between(From, To, Part, Most, Placed0, Placed) :-
    (   Most > 0,
        part_long_enough(From, To, Part),
        best_tab(From, To, Part, Which-Tab)
    ->  tab_entered(Which, Tab, Part, Outline, Low, High),
        More is Most-1,
        placed_between(From, Low, Part, More, Placed0, Placed1),
        Placed1 = [Which-Outline|Placed2],
        placed_between(High, To, Part, More, Placed2, Placed)
    ;   Placed0 = Placed
    ).

%   What is left of a seam is to be worth the trouble: a fifth of it, not less
%   than three times the least tab.

part_long_enough(From, To, part(Length,Width,_)) :-
    Part is To-From,
    least_tab(Width, Least),
    Part >= 2*Least,
    (   Part >= 0.99*Length
    ->  true
    ;   Part >= max(3*Least, 0.2*Length)
    ).

tab_entered(Which, Tab, part(Length,_,Glues), Outline, Low, High) :-
    nth_glue(Which, Glues, glue(Side,Own)),
    tab_outline(Side, Tab, Outline),
    shapes_add(Own, Outline),
    tab_ends(Tab, Start, End),
    (   Which =:= 1
    ->  Low = Start,
        High = End
    ;   Low is Length-End,
        High is Length-Start
    ).

nth_glue(1, [Glue|_], Glue).
nth_glue(2, [_,Glue|_], Glue).

%   best_tab(From, To, Part, Which-Tab): the largest form that is free, on the
%   first side if on both; or the largest form trimmed, if that leaves more. A
%   tab is a list of Along-Deep, its corners: how far along its own side, and
%   how far from that.

best_tab(From, To, Part, Best) :-
    Part = part(_, Width, _),
    Length is To-From,
    findall(Less-Shape,
            ( tab_shape(Width, Length, Shape, Area), Less is -Area ),
            Forms0),
    keysort(Forms0, Forms),
    Forms = [Most-Largest|_],
    (   free_form(Forms, From, To, Part, Less, Free)
    ->  true
    ;   Less = 0
    ),
    findall(Trim-Trimmed,
            ( Less > Most/2,
              trimmed_form(Largest, From, To, Part, Trim, Trimmed),
              Trim < Less
            ),
            Trims),
    keysort(Trims, Sorted),
    (   Sorted = [_-Best|_]
    ->  true
    ;   Less < 0,
        Best = Free
    ).

free_form(Forms, From, To, Part, Less, Which-Tab) :-
    member(Less-Shape, Forms),
    glue_between(From, To, Part, Which, Start, End, glue(Side,Own)),
    room_shape(Shape, Room),
    shape_tab(Room, Start, End, Needed),
    tab_outline(Side, Needed, Outline),
    touching(Tolerance),
    shapes_free(Own, Outline, Tolerance),
    !,
    shape_tab(Shape, Start, End, Tab).

trimmed_form(Largest, From, To, Part, Less, Which-Tab) :-
    Part = part(_, Width, _),
    least_tab(Width, Least),
    glue_between(From, To, Part, Which, Start, End, glue(Side,Own)),
    Largest = tab(In1, Run1, In2, Run2, Deep),
    Low is Start+In1,
    High is End-In2,
    Slope1 is Run1/Deep,
    Slope2 is Run2/Deep,
    trimmed_tab(within(Low,High,Slope1,Slope2,Deep), Least,
                sg_pattern_tab:tab_free(Own, Side), Tab),
    loop_area(Tab, Area),
    Less is -abs(Area).

%!  tab_free(+Own, +Side, +Tab) is semidet.
%
%   Nothing of the shapes Own is where Tab would be.

tab_free(Own, Side, Tab) :-
    tab_outline(Side, Tab, Outline),
    touching(Tolerance),
    shapes_free(Own, Outline, Tolerance).

%   glue_between(From, To, Part, Which, Start, End, Glue): Start and End are the
%   two places as the side sees them.

glue_between(From, To, part(_,_,[Glue|_]), 1, From, To, Glue) :-
    Glue \== none.
glue_between(From, To, part(Length,_,[_,Glue|_]), 2, Start, End, Glue) :-
    Start is Length-To,
    End is Length-From.

%   A tab needs a little more room than it takes: a knife has to go between it
%   and what is beside it, and its line is to be no one else's.

room_shape(tab(In1,Run1,In2,Run2,Deep), tab(In1,More1,In2,More2,More)) :-
    More1 is 0.85*Run1,
    More2 is 0.85*Run2,
    More is 1.05*Deep.

shape_tab(tab(In1,Run1,In2,Run2,Deep), Start, End,
          [A-0.0,B-Deep,C-Deep,D-0.0]) :-
    A is Start+In1,
    B is A+Run1,
    D is End-In2,
    C is D-Run2.

tab_ends([Start-_|Corners], Start, End) :-
    append(_, [End-_], Corners),
    !.

%   tab_outline(Side, Tab, Points): in the order of the outline; the face is on
%   the left of Side, the tab on its right. The ends of the side itself are
%   copied, not computed.

tab_outline(Side, Tab, Points) :-
    Side = side(_, _, _-A, _-B, _),
    A = XA-YA,
    B = XB-YB,
    side_length(Side, Length),
    U is (XB-XA)/Length,
    V is (YB-YA)/Length,
    maplist(tab_point(A, B, Length, U, V), Tab, Points).

tab_point(A, B, Length, U, V, Along-Deep, Point) :-
    (   Deep =:= 0,
        \+ less_part(0.0, Along/Length)
    ->  Point = A
    ;   Deep =:= 0,
        \+ less_part(Along/Length, 1.0)
    ->  Point = B
    ;   A = XA-YA,
        X is XA + Along*U + Deep*V,
        Y is YA + Along*V - Deep*U,
        Point = X-Y
    ).

:- decision(tab_shape/4, "The forms that a tab may have").

%!  tab_shape(+Width, +Length, -Shape, -Area) is nondet.
%
%   True when a seam of Length may have a tab of this Shape, at most Width deep:
%   tab(In1,Run1,In2,Run2,Deep) begins In1 from the start of the seam and ends
%   In2 from its end, is Deep, and its upper corners stand Run1 and Run2 farther
%   in. The largest that has room is taken; what is trimmed to its room is a
%   part of the largest form. A decision.

tab_shape(Width, Length, tab(In1,Run1,In2,Run2,Deep), Area) :-
    least_tab(Width, Least),
    member(Part, [1.0,0.75,0.55]),
    Deep is min(Width, 0.45*Length)*Part,
    Deep >= Least,
    member(Slope1-Slope2, [ 1-1, 1.8-1.8, 3.5-3.5, 1-3.5, 3.5-1 ]),
    Run1 is Deep*Slope1,
    Run2 is Deep*Slope2,
    member(In-Out, [0-0, 0.15-0, 0-0.15, 0.15-0.15]),
    In1 is In*Length,
    In2 is Out*Length,
    Base is Length-In1-In2,
    Base >= 2*Least,
    Top is Base-Run1-Run2,
    Top >= 0.1*Length,
    Area is (Base+Top)/2*Deep.
