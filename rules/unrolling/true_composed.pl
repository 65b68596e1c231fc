:- module(sg_true_composed,
          [ composed_unrolled/4         % +S, +Part, +Options, -Pattern
          ]).
:- use_module('../near',
              [ tolerance/2, same_angle/2, before_angle/2, between_angles/3,
                whole_turns/2, less_part/2
              ]).
:- use_module('../primitive/primitive', [primitive_faces/3]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../store', [segment/3]).
:- use_module('../solid/trimmed', [part_named/2, part_named/4]).
:- use_module(true_divide, [facet_index/2, generator_spans/5]).
:- use_module(true_layout, [chord_tolerance/3, strip_ends/3, strip_layout/6]).
:- use_module(true_pieces,
              [ composed_seam/5, creases/3, direction_of/3, divided_at/3,
                from_seam/3, is_round/1, on_border/2, piece_facets/2,
                pieces_found/4, place_of/3
              ]).
:- use_module(true_parts, [drawn_borders/2, pieces_as_drawn/3]).
:- use_module(true_plate, [plate_layer/2]).
:- use_module(true_resized, [transition_parts_as/3, transition_resized/3]).
:- use_module(library(apply), [foldl/5, foldl/6, maplist/3, maplist/4]).
:- use_module(library(assoc),
              [assoc_to_list/2, get_assoc/3, list_to_assoc/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists),
              [append/2, last/2, max_list/2, member/2, min_list/2, nth1/3,
               reverse/2]).
:- use_module(library(option), [option/2]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_keys_values/3]).
/** <module> A transition unrolled: its pieces one beside the other.

Each piece of a transition (primitive_transition.pl) unrolls by itself: a fan
lies flat, and a part of a cone unrolls as cones do. Neighbours have a generator
in common, of one length in both; so each piece is turned and moved to where its
first generator lies on the last one of the piece before.

Pieces are those of true_pieces.pl. A piece is divided where the pattern begins,
and in the middle of it if half of it is wanted.
*/

%!  composed_unrolled(+S, +Part, +Options, -Pattern) is det.
%
%   Pattern, as true_pattern.pl has it, is Part of segment S, a transition,
%   unrolled. Options as of true_development/4, but: seam(Degrees) is a
%   direction, by default that of the middle of the flat side where it is
%   shortest; generators(N) divides each round outline in N, besides those
%   between pieces.
%
%   @error as true_development/4

composed_unrolled(S, Part, Options,
                  pattern(S, creases(Creases), Facets, Points, Curves,
                          Marks)) :-
    pieces_found(S, Part, Leaf, Pieces1),
    drawn_borders(Leaf, Borders),
    composed_seam(Pieces1, Borders, Options, Seam, Around),
    divided_at(Seam, Pieces1, Pieces2),
    Middle is Seam + 180.0,
    (   option(half(true), Options)
    ->  divided_at(Middle, Pieces2, Pieces3)
    ;   Pieces3 = Pieces2
    ),
    from_seam(Pieces3, Seam, Pieces4),
    plate_layer(Options, Layer),
    neutral_pieces(S, Leaf, Layer, Neutral),
    motions(Pieces4, Neutral, Motions),
    chord(Options, Pieces4, Chord),
    maplist(piece_laid(Neutral, Chord), Pieces4, Motions, Laid0),
    (   option(half(true), Options)
    ->  half_left(Laid0, S-Part, Around, Middle, Neutral, Laid),
        Joined = false
    ;   Laid = Laid0,
        Joined = Around
    ),
    maplist(laid_piece, Laid, Pieces),
    creases(Pieces, Joined, Creases),
    generators(Laid, Borders, Around, Options, Generators),
    least_corner(Laid, Corner, Size),
    marks(Laid, Generators, Neutral, Corner, Marks),
    merged(Laid, Corner, Size, Facets0, Points, Curves),
    pieces_as_drawn(S, Facets0, Facets).


                /*******************************
                *            LAYING            *
                *******************************/

%   motions(Pieces, Neutral, Motions): the first generator of each goes on the
%   last of the one before; then all are turned until the generator in the
%   middle stands upright.

motions(Pieces, Neutral, Motions) :-
    foldl(piece_motion(Neutral), Pieces, Motions0, (0.0-0.0)-(0.0-1.0), _),
    middle_piece(Pieces, Motions0, Piece, Motion, G),
    place_of(Piece, G, T),
    generator_ends(Piece, Neutral, T, Ends0),
    maplist(moved(Motion), Ends0, [X1-Y1,X2-Y2]),
    DX is X2-X1,
    DY is Y2-Y1,
    Length is sqrt(DX*DX + DY*DY),
    Cos is DY/Length,
    Sin is DX/Length,
    maplist(after(motion(Cos, Sin, 0.0, 0.0)), Motions0, Motions).

middle_piece(Pieces, Motions, Piece, Motion, G) :-
    Pieces = [piece(_, _, _, First-_, _, _, _)|_],
    last(Pieces, piece(_, _, _, _-Last, _, _, _)),
    G is (First+Last)/2.0,
    nth1(I, Pieces, Piece),
    Piece = piece(_, _, _, _-G2, _, _, _),
    \+ less_part(G2, G),
    !,
    nth1(I, Motions, Motion).

%   piece_motion(Neutral, Piece, Motion, Ends0, Ends): its first generator goes
%   to where Ends0, Low-High, are; Ends is where its last one is then.

piece_motion(Neutral, Piece, Motion, (X0-Y0)-(X1-Y1), Ends) :-
    Piece = piece(_, _, T1-T2, _, _, _, _),
    generator_ends(Piece, Neutral, T1, [A0-B0,A1-B1]),
    UX is A1-A0,
    UY is B1-B0,
    WX is X1-X0,
    WY is Y1-Y0,
    Size is sqrt((UX*UX + UY*UY)*(WX*WX + WY*WY)),
    Cos is (UX*WX + UY*WY)/Size,
    Sin is (UX*WY - UY*WX)/Size,
    X is X0 - (Cos*A0 - Sin*B0),
    Y is Y0 - (Sin*A0 + Cos*B0),
    Motion = motion(Cos, Sin, X, Y),
    generator_ends(Piece, Neutral, T2, Ends0),
    maplist(moved(Motion), Ends0, [Low,High]),
    Ends = Low-High.

%   generator_ends(Piece, Neutral, T, Ends): [Low,High], unrolled.

generator_ends(Piece, Neutral, T, Ends) :-
    Piece = piece(_, End, _, _, _, _, _),
    strip(Piece, Neutral, Strip),
    (   End == base
    ->  strip_ends(Strip, [T-0.0,T-1.0], Ends)
    ;   strip_ends(Strip, [T-1.0,T-0.0], Ends)
    ).

%   strip(Piece, Neutral, Strip): as true_layout.pl has it.

strip(piece(Name, _, Ts0, _, _, Shape, Sense), Neutral,
      strip(Shape, Rolled, Sense)) :-
    (   memberchk(rolled(Name, Surface, Ts, Us), Neutral)
    ->  Rolled = rolled(Surface, Ts, Us)
    ;   Shape = shape(Surface, _, _),
        Rolled = rolled(Surface, Ts0, Ts0)
    ).

%   neutral_pieces(S, Leaf, Layer, Neutral): Neutral is a list of rolled(Part,
%   Surface, Ts, Us): instead of the piece Part between Ts Surface is unrolled,
%   between Us: of the transition whose outlines are Layer larger all round.

neutral_pieces(S, Leaf, Layer, Neutral) :-
    (   Layer =:= 0.0
    ->  Neutral = []
    ;   segment(Leaf, _, Term),
        transition_resized(Term, Layer, Resized0),
        transition_parts_as(Term, Resized0, Resized),
        catch(primitive_faces(Resized, _, Surfaces),
              error(model_error(_), _), fail),
        placed_surface(Leaf, _, transition(pieces(Places0))),
        memberchk(_-transition(pieces(Places)), Surfaces),
        maplist(rolled_piece(Surfaces), Places0, Places, Neutral)
    ->  true
    ;   part_named(S, Named),
        throw(error(geometry_error(true(no_offset(Named))), _))
    ).

rolled_piece(Surfaces, piece(Name, End, Ts, _), piece(Name, End, Us, _),
             rolled(Name, Surface, Ts, Us)) :-
    memberchk(Name-Surface, Surfaces).

moved(motion(Cos, Sin, X0, Y0), X1-Y1, X-Y) :-
    X is Cos*X1 - Sin*Y1 + X0,
    Y is Sin*X1 + Cos*Y1 + Y0.

%   after(Second, First, Both): First, then Second.

after(motion(C2, S2, X2, Y2), motion(C1, S1, X1, Y1), motion(C, S, X, Y)) :-
    C is C2*C1 - S2*S1,
    S is S2*C1 + C2*S1,
    moved(motion(C2, S2, X2, Y2), X1-Y1, X-Y).

%   piece_laid(Neutral, Chord, Piece, Motion, Laid): Laid is laid(Piece, Motion,
%   Points, Curves), assocs from keys and pairs of keys.

piece_laid(Neutral, Chord, Piece, Motion,
           laid(Piece, Motion, Points, Curves)) :-
    piece_facets(Piece, Facets),
    strip(Piece, Neutral, Strip),
    strip_layout(Strip, Facets, Motion, Chord, Points, Curves).

%   chord(Options, Pieces, Chord): by default 1.0e-4 of the size.

chord(Options, Pieces, Chord) :-
    findall(Reach, member(piece(_, _, _, _, _, shape(_, Reach, _), _), Pieces),
            Reaches),
    max_list(Reaches, Most),
    Size is 4.0*Most,
    chord_tolerance(Options, Size, Chord).


                /*******************************
                *             HALF             *
                *******************************/

%   half_left(Laid0, Name, Around, Middle, Neutral, Laid): the half before the
%   direction Middle, if the other one is its mirror image.

half_left(Laid0, Name, Around, Middle, Neutral, Laid) :-
    findall(One, ( member(One, Laid0), before(One, Middle) ), Laid),
    (   Around == true,
        last(Laid, laid(Piece, Motion, _, _)),
        Piece = piece(_, _, _-T2, _, _, _, _),
        generator_ends(Piece, Neutral, T2, Ends0),
        maplist(moved(Motion), Ends0, Axis),
        findall(Point,
                ( member(laid(_, _, Points, _), Laid0),
                  assoc_to_list(Points, Pairs),
                  member(_-Point, Pairs) ),
                Corners),
        mirrored(Corners, Axis)
    ->  true
    ;   Name = S-Part,
        part_named(S, Part, Named, Shown),
        throw(error(geometry_error(true(not_symmetric(Named, Shown))), _))
    ).

before(laid(piece(_, _, _, _-G2, _, _, _), _, _, _), Middle) :-
    \+ before_angle(Middle, G2).

%   mirrored(Points, Axis): the mirror image of each in the line through the two
%   points of Axis is one of them.

mirrored(Points, [X1-Y1,X2-Y2]) :-
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    AX is (X2-X1)/Length,
    AY is (Y2-Y1)/Length,
    findall(Off-Along,
            ( member(X-Y, Points),
              Along is (X-X1)*AX + (Y-Y1)*AY,
              Off is (X-X1)*AY - (Y-Y1)*AX ),
            Places),
    findall(Far, ( member(Off-_, Places), Far is abs(Off) ), Fars),
    max_list([Length|Fars], Size),
    tolerance(surface, Of),
    Grid is Of*Size,
    findall(Bin-(Off-Along),
            ( member(Off-Along, Places), bin(Grid, Off, Bin) ),
            Bins0),
    keysort(Bins0, Bins),
    group_pairs_by_key(Bins, Groups),
    list_to_assoc(Groups, Table),
    \+ ( member(Off-Along, Places),
         \+ has_image(Table, Grid, Off, Along)
       ).

bin(Grid, Off, Bin) :-
    Bin is round(Off/Grid/10.0).

has_image(Table, Grid, Off0, Along0) :-
    Off is -Off0,
    bin(Grid, Off, Middle),
    From is Middle-1,
    To is Middle+1,
    between(From, To, Bin),
    get_assoc(Bin, Table, Places),
    member(Off1-Along1, Places),
    abs(Off1-Off) < Grid,
    abs(Along1-Along0) < Grid,
    !.


                /*******************************
                *          GENERATORS          *
                *******************************/

%   generators(Laid, Borders, Around, Options, Generators): generator(Number,
%   Piece, T, Beside): at T of Piece, or of Beside, which is on its other side
%   (`none`: it is within Piece). Borders are the directions between facets.

generators(Laid, Borders, Around, Options, Generators) :-
    (   option(generators(N), Options)
    ->  must_be(positive_integer, N)
    ;   N = none
    ),
    findall(One, generator(Laid, Borders, N, One), Ones),
    length(Ones, Count),
    findall(generator(Number, Piece, T, Beside),
            ( nth1(I, Ones, at(Piece, T, Beside)),
              (   I =:= Count,
                  Around == true,
                  goes_round(Laid)
              ->  Number = 1
              ;   Number = I
              ) ),
            Generators).

goes_round(Laid) :-
    Laid = [laid(piece(_, _, _, G1-_, _, _, _), _, _, _)|_],
    last(Laid, laid(piece(_, _, _, _-G2, _, _, _), _, _, _)),
    \+ before_angle(G2-G1, 360.0).

%   generator(Laid, Borders, N, At) is nondet: from left to right: where each
%   piece begins, within it, and where the last one ends. Where cones take turns
%   they begin between facets: of these, too, N of each outline are numbered.

generator(Laid, Borders, N, at(One, T, Beside)) :-
    nth1(I, Laid, One),
    One = laid(Piece, _, _, _),
    Piece = piece(_, _, T1-_, _, _, _, _),
    (   T = T1,
        I0 is I-1,
        (   nth1(I0, Laid, Before)
        ->  Beside = Before,
            numbered_between(N, Borders, Before, One)
        ;   Beside = none
        )
    ;   Beside = none,
        generator_within(Piece, Borders, N, T)
    ).
generator(Laid, _, _, at(One, T, none)) :-
    last(Laid, One),
    One = laid(piece(_, _, _-T, _, _, _, _), _, _, _).

%   numbered_between(N, Borders, Before, After): the generator where After
%   begins.

numbered_between(none, Borders, _, laid(Piece, _, _, _)) :-
    !,
    Piece = piece(_, _, _, G-_, _, _, _),
    on_border(Borders, G).
numbered_between(N, _, laid(Piece1, _, _, _), laid(Piece2, _, _, _)) :-
    (   \+ ( is_round(Piece1), is_round(Piece2) )
    ->  true
    ;   Piece2 = piece(_, _, T-_, _, _, _, _),
        same_angle(T, 360.0*round(T*N/360.0)/N)
    ).

generator_within(Piece, Borders, N, T) :-
    is_round(Piece),
    Piece = piece(_, _, T1-T2, _, Facets, _, _),
    (   N == none
    ->  findall(T0,
                ( member(facet(_, T0, _, _), Facets),
                  direction_of(Piece, T0, G),
                  on_border(Borders, G) ),
                Ts0)
    ;   First is ceiling(T1*N/360.0),
        Last is floor(T2*N/360.0),
        findall(T0, ( between(First, Last, K), T0 is 360.0*K/N ), Ts0)
    ),
    sort(Ts0, Ts),
    member(T, Ts),
    between_angles(T1, T, T2).

%   marks(Laid, Generators, Neutral, Corner, Marks): as layout_marks/6.

marks(Laid, Generators, Neutral, Corner, Marks) :-
    maplist(laid_index, Laid, Indexed),
    findall(Mark,
            ( member(Generator, Generators),
              generator_mark(Generator, Indexed, Neutral, Corner, Mark) ),
            Marks).

laid_piece(laid(Piece, _, _, _), Piece).

laid_index(One, One-Index) :-
    One = laid(Piece, _, _, _),
    piece_facets(Piece, Facets),
    facet_index(Facets, Index).

generator_mark(generator(Number, One0, T0, Beside), Indexed, Neutral, X0-Y0,
               mark(Number, Degrees, 0.0, 0.0, Length, P, Q)) :-
    (   spans_at(One0, T0, Indexed, Spans0),
        Spans0 \== []
    ->  One-T-Spans = One0-T0-Spans0
    ;   Beside = laid(piece(_, _, _-T, _, _, _, _), _, _, _),
        One = Beside,
        spans_at(One, T, Indexed, Spans)
    ),
    One = laid(Piece, Motion, _, _),
    direction_of(Piece, T, G),
    whole_turns(G, By),
    Degrees is G - By + 0.0,
    in_height_order(Piece, Spans, Upward),
    member(H1-H2, Upward),
    strip(Piece, Neutral, Strip),
    strip_ends(Strip, [T-H1,T-H2], Ends),
    Motion = motion(Cos, Sin, X3, Y3),
    X is X3-X0,
    Y is Y3-Y0,
    maplist(moved(motion(Cos, Sin, X, Y)), Ends, [P,Q]),
    P = X1-Y1,
    Q = X2-Y2,
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2).

spans_at(One, T, Indexed, Spans) :-
    One = laid(Piece, _, _, _),
    Piece = piece(_, _, _, _, _, Shape, Sense),
    memberchk(One-Index, Indexed),
    generator_spans(Index, T, Sense, Shape, Spans).

in_height_order(piece(_, End, _, _, _, _, _), Spans, Upward) :-
    (   End == base
    ->  Upward = Spans
    ;   reverse(Spans, Spans1),
        findall(B-A, member(A-B, Spans1), Upward)
    ).


                /*******************************
                *           MERGING            *
                *******************************/

%   least_corner(Laid, X0-Y0, Size): of all points.

least_corner(Laid, X0-Y0, Size) :-
    findall(Point, laid_point(Laid, Point), All),
    pairs_keys_values(All, Xs, Ys),
    min_list(Xs, X0),
    min_list(Ys, Y0),
    max_list(Xs, X1),
    max_list(Ys, Y1),
    Size is max(X1-X0, Y1-Y0).

laid_point(Laid, Point) :-
    member(laid(_, _, Points, Curves), Laid),
    (   assoc_to_list(Points, Pairs),
        member(_-Point, Pairs)
    ;   assoc_to_list(Curves, Pairs),
        member(_-Between, Pairs),
        member(Point, Between)
    ).

%   merged(Laid, Corner, Size, Facets, Points, Curves): one key k(Id, N) for
%   each place where the point Id comes to lie, from Corner on; facets are
%   between directions.

merged(Laid, X0-Y0, Size, Facets, Points, Curves) :-
    length(Laid, Count),
    findall(I, between(1, Count, I), Is),
    maplist(numbered_points, Is, Laid, Lists),
    append(Lists, Placed0),
    keysort(Placed0, Placed),
    group_pairs_by_key(Placed, Groups),
    tolerance(place, Of),
    Near is Of*Size,
    maplist(places_told_apart(Near), Groups, Named),
    append(Named, Pairs),
    findall((I-Key)-New, member(named(I, Key, New, _), Pairs), Renaming0),
    list_to_assoc(Renaming0, Renaming),
    findall(New-(X-Y),
            ( member(named(_, _, New, X1-Y1), Pairs),
              X is X1-X0,
              Y is Y1-Y0 ),
            Points0),
    sort(1, @<, Points0, Points1),
    list_to_assoc(Points1, Points),
    maplist(renamed_facets(Renaming), Is, Laid, FacetLists),
    append(FacetLists, Facets),
    maplist(renamed_curves(Renaming, X0-Y0), Is, Laid, CurveLists),
    append(CurveLists, Curves0),
    sort(1, @<, Curves0, Curves1),
    list_to_assoc(Curves1, Curves).

numbered_points(I, laid(_, _, Points, _), Placed) :-
    assoc_to_list(Points, Pairs),
    findall(Id-at(I, Key, Place),
            ( member(Key-Place, Pairs),
              Key = k(Id, _) ),
            Placed).

places_told_apart(Near, Id-Ats, Named) :-
    foldl(place_named(Near, Id), Ats, Named, []-1, _).

place_named(Near, Id, at(I, Key, X-Y), named(I, Key, k(Id, N), Place),
            Known0-Next0, Known-Next) :-
    (   member((X1-Y1)-N1, Known0),
        abs(X-X1) < Near,
        abs(Y-Y1) < Near
    ->  N = N1,
        Place = X1-Y1,
        Known = Known0,
        Next = Next0
    ;   N = Next0,
        Place = X-Y,
        Known = [(X-Y)-N|Known0],
        Next is Next0+1
    ).

renamed_facets(Renaming, I, laid(Piece, _, _, _), Facets) :-
    piece_facets(Piece, Facets0),
    maplist(renamed_facet(Renaming, I, Piece), Facets0, Facets).

renamed_facet(Renaming, I, Piece, facet(P, T1, T2, Halves0),
              facet(P, G1, G2, Halves)) :-
    direction_of(Piece, T1, G1),
    direction_of(Piece, T2, G2),
    findall(half(A, B, Label),
            ( member(half(A0, B0, Label), Halves0),
              get_assoc(I-A0, Renaming, A),
              get_assoc(I-B0, Renaming, B),
              A \== B ),
            Halves).

renamed_curves(Renaming, X0-Y0, I, laid(_, _, _, Curves0), Curves) :-
    assoc_to_list(Curves0, Pairs),
    findall(Edge-Points,
            ( member((A0-B0)-Points0, Pairs),
              get_assoc(I-A0, Renaming, A),
              get_assoc(I-B0, Renaming, B),
              findall(X-Y,
                      ( member(X1-Y1, Points0), X is X1-X0, Y is Y1-Y0 ),
                      Points1),
              (   A @< B
              ->  Edge = A-B,
                  Points = Points1
              ;   Edge = B-A,
                  reverse(Points1, Points)
              ) ),
            Curves).
