:- module(sg_pattern_drawing,
          [ pattern_drawing/3,          % +Ds, +Options, -Drawings
            pattern_layout/3            % +Ds, +Options, -Layout
          ]).
:- use_module(pattern_fit, [fitted_pieces/5, joint_depth/3]).
:- use_module(pattern_lines, [outline_loops/2, piece_line/4]).
:- use_module(pattern_nest, [nested/3]).
:- use_module(pattern_number, [partner_sheets/3, seam_numbers/2]).
:- use_module(pattern_outline, [loop_area/2]).
:- use_module(pattern_paper,
              [ extent_checked/1, grid_line/3, line_strokes/4, page_room/3,
                page_sheet/2, pages_checked/1, paper_checked/1, pattern_paper/3,
                sheet_line/4, sheet_of/4 ]).
:- use_module(pattern_piece, [pattern_pieces/3]).
:- use_module(pattern_text, [written/5]).
:- use_module(pattern_table, [pattern_tables/4, table_loops/2]).
:- use_module(pattern_scale,
              [fitting_scale/4, height_scale/4, pages_scale/4, scale_text/2]).
:- use_module(pattern_tile, [tiled/4]).
:- use_module(pattern_title, [pattern_title/2, pattern_titles/2]).
:- use_module(pattern_parted, [parted_segments/2]).
:- use_module(pattern_yield, [pattern_yield/2]).
:- use_module(pattern_want, [wanted_texts/4]).
:- use_module('../sheet/sheet_paper', [unit_millimetres/2]).
:- use_module(pattern_view,
              [ moved/3, sheet_move/3, piece_view/5, table_view/3,
                letters_by_piece/2
              ]).
:- use_module(library(apply),
              [ exclude/3, foldl/4, foldl/6, include/3, maplist/3, maplist/4,
                maplist/5, partition/4
              ]).
:- use_module(library(assoc), [empty_assoc/1]).
:- use_module(library(error), [domain_error/2]).
:- use_module(library(lists),
              [append/2, append/3, member/2, min_list/2, nth1/3, sum_list/2]).
:- use_module(library(option), [option/2, option/3, select_option/4]).
:- use_module(library(pairs),
              [group_pairs_by_key/2, pairs_values/2]).
/** <module> Patterns that one can make: sheets to cut, fold and glue.

A pattern (a segment of kind `pattern`) is taken apart into pieces, these get
tabs, are nested on sheets, and there are drawn with numbers and names. Where
things are does not depend on the format that they are written in: a drawing
(sheet.pl) for each sheet, one of its views for each piece. Roles of lines are
those of pattern_look.pl.

@see pattern_file.pl writes them
*/

:- set_prolog_flag(optimise, true).

%!  pattern_drawing(+Ds, +Options, -Drawings) is det.
%
%   Drawings, one for each sheet or page, are the patterns Ds together. Options:
%
%     - scale(N:M), or scale(Factor): a true scale, default 1:1; unit(U): what
%       one is in the model, default mm
%     - height(H), pages(N) or fit(true): the scale at which what the patterns
%       are of is H mm high, they take at most N pages, or no piece has to be
%       divided for the page; it is told
%     - page(P): A4 to A0, perhaps with -landscape, letter, `WxH` or W-H; if not
%       given one sheet as large as needed. margin(M): free all round, 10 mm;
%       gap(G): between pieces, 3 mm
%     - kerf(K): what is cut is moved outwards by K/2 mm, of holes inwards
%     - tile(true): pieces are not divided for the page but the sheet is, into
%       pages that overlap by overlap(O), 10 mm
%     - tabs(W): tabs W mm wide at one side of each seam; tab_sides(On), see
%       tabs/5; open_slits(Open):
%       pieces are parted until each seam has room for one (true), not (false),
%       or if more than a tenth of the seam had none (auto, as is usual)
%     - numbers(Bool): of partners, on both sides of each seam, default true
%     - names(What): of faces: false (default), true (their numbers), `words`;
%       or `pieces`: each piece has the name of its pattern
%     - angles(Bool): of folds, default false
%     - fold_threshold(Degrees): flatter folds are not drawn, default 0.5
%     - inside(Bool): seen from inside: mirrored, texts are not
%     - grid(Step): a grid of Step mm
%     - title(Text): beside the check bar
%     - plates(Plates): D-Measures of plate_measures/4: bends have numbers, and
%       tables
%     - table(Bool): of true lengths, for patterns with generators; default true
%
%   Of several patterns each piece and each table has its name
%   (pattern_title.pl).
%   What was divided, or left out for want of room, is told by messages.
%
%   @error usage_error(pattern(What)): see page_sheet/2; no_height, no_scale
%   @error domain_error(unit, U), domain_error(scale, Scale)

pattern_drawing(Ds, Options0, Drawings) :-
    paper_checked(Options0),
    titles(Ds, Options0, Titles),
    scale_found(Ds, [titles(Titles)|Options0], Options),
    pattern_layout(Ds, Options, Layout),
    layout_drawings(Layout, Options, Drawings0),
    (   option(tile(true), Options)
    ->  Drawings0 = [Drawing],
        tiled(Options, Drawing, [], Tiles),
        table_pages(Ds, Options, Pages),
        append(Tiles, Pages, Drawings)
    ;   Drawings = Drawings0,
        told_yield(Options, Drawings)
    ).

%   titles(Ds, Options, Titles): one pattern alone has one if that is asked for.

titles(Ds, Options, Titles) :-
    pattern_titles(Ds, Titles0),
    (   Titles0 == [],
        option(names(pieces), Options)
    ->  findall(D-Title, ( member(D, Ds), pattern_title(D, Title) ), Titles)
    ;   Titles = Titles0
    ).

%   told_yield(Options, Drawings): of sheets that are as large as they are, not
%   as large as needed.

told_yield(Options, Drawings) :-
    (   ( option(page(_), Options) ; option(pages(_), Options) )
    ->  pattern_yield(Drawings, Yield),
        print_message(informational,
                      sanggwan(pattern(yield(Yield.yield, Yield.sheets))))
    ;   true
    ).

%   scale_found(Ds, Options0, Options): the scale that is asked for by what
%   should come of it is among Options.

scale_found(Ds, Options0, [scale(Scale)|Options]) :-
    wanted_scale(Options0, Want),
    !,
    exclude(says_scale, Options0, Options),
    found_scale(Want, Ds, Options, Scale),
    print_message(informational, sanggwan(pattern(scale(Scale)))).
scale_found(_, Options, Options).

wanted_scale(Options, height(H)) :-
    option(height(H), Options).
wanted_scale(Options, pages(N)) :-
    option(pages(N), Options).
wanted_scale(Options, fit) :-
    option(fit(true), Options).

says_scale(Option) :-
    functor(Option, Name, _),
    memberchk(Name, [scale,unit,height]).

found_scale(height(H), Ds, Options, Scale) :-
    option(up(Axis), Options, z),
    height_scale(Ds, Axis, H, Scale).
found_scale(fit, Ds, Options, Scale) :-
    unit_pieces(Ds, Options, Pieces, Paper),
    fitting_scale(Pieces, Paper, Options, Scale).
found_scale(pages(N), Ds, Options, Scale) :-
    unit_pieces(Ds, Options, Pieces, Paper),
    Paper = room(W, H, Gap),
    pieces_points(Pieces, Pointss),
    maplist(loop_area, Pointss, Areas),
    sum_list(Areas, Area),
    Room is N*W*H,
    joint_depth(Options, _, Deep),
    Apart is Gap+Deep,
    nesting_options(Options, Apart, Nesting),
    pages_scale(Area, Room, sg_pattern_drawing:in_pages(Ds, Nesting, N),
                Near),
    (   member(Share, [1.04,1.0,0.97,0.94,0.91,0.88,0.8,0.7,0.6,0.5]),
        Scale is Share*Near,
        in_pages(Ds, Options, N, Scale)
    ->  true
    ;   throw(error(usage_error(pattern(no_scale)), _))
    ).

%   nesting_options(Options0, Apart, Options): pieces without joints, but so far
%   Apart that these have room: about where the best scale is.

nesting_options(Options0, Apart, [gap(Apart)|Options]) :-
    exclude(says_joints, Options0, Options).

says_joints(Option) :-
    functor(Option, Name, _),
    memberchk(Name, [tabs,lap,lock,open_slits,gap]).

%   unit_pieces(Ds, Options, Pieces, Paper): the pieces in units of the model.

unit_pieces(Ds, Options, Pieces, Paper) :-
    maplist(pieces_of(look(1,outside)), Ds, Piecess),
    append(Piecess, All),
    include(has_area, All, Pieces),
    option(gap(Gap), Options, 3),
    pattern_paper(Options, Gap, Paper).

in_pages(Ds, Options, N, Scale) :-
    pattern_layout(Ds, [scale(Scale),told(false)|Options], Layout),
    Layout = layout(_, _, Sheets, _, _, _),
    length(Sheets, Count),
    Count =< N.

%   table_pages(Ds, Options, Drawings): tables on pages of their own, since
%   tiles would cut through their rows.

table_pages(Ds, Options0, Drawings) :-
    page_sheet(Options0, Sheet),
    option(gap(Gap), Options0, 3),
    page_room(Sheet, Gap, Paper),
    factor(Options0, Factor),
    pattern_tables(Ds, Options0, Paper, Tables),
    maplist(named_table, Tables, Loops),
    nested(Loops, Paper, nested(_,Places)),
    maplist(laid, Tables, Tables, Places, Laid),
    laid_sheets(Laid, Sheets),
    empty_assoc(None),
    select_option(tile(_), Options0, Options, _),
    layout_drawings(layout(Factor,Sheet,Sheets,None,None,None), Options,
                    Drawings).


                /*******************************
                *            LAYOUT            *
                *******************************/

%!  pattern_layout(+Ds, +Options, -Layout) is det.
%
%   Layout is layout(Factor, Sheet, Sheets, Numbers, Tabs, Butt): Factor is how
%   many millimetres a unit of the model is, Sheet is as in pattern_paper.pl,
%   Sheets are lists of laid(Piece,Outline,Place): what is on each, Place as of
%   nested/3.

pattern_layout(Ds, Options,
               layout(Factor,Sheet,Sheets,Numbers,Tabs,Butt)) :-
    factor(Options, Factor),
    (   option(inside(true), Options)
    ->  From = inside
    ;   From = outside
    ),
    maplist(pieces_of(look(Factor,From)), Ds, Piecess),
    append(Piecess, All),
    include(has_area, All, Pieces0),
    option(gap(Gap0), Options, 3),
    option(kerf(Kerf), Options, 0),
    Gap is Gap0+Kerf,
    pattern_paper(Options, Gap, Paper),
    pieces_points(Pieces0, Pointss),
    extent_checked(Pointss),
    least_pages(Pointss, Paper, LeastPages),
    pages_checked(LeastPages),
    fitted_pieces(Pieces0, Paper, Options, Fitted, tabs(Tabs,Butt)),
    maplist(fitted_parts, Fitted, Pieces, Outlines),
    seam_numbers(Pieces, Numbers),
    maplist(named_loops, Pieces, Outlines, Loops0),
    layout_tables(Ds, Options, Paper, Tables),
    maplist(named_table, Tables, TableLoops),
    append(Loops0, TableLoops, Loops),
    nested(Loops, Paper, nested(Size,Places0)),
    sheet_of(Options, Paper, Size, Sheet),
    placed_all(Loops, Places0, Places),
    append(Pieces, Tables, Things),
    append(Outlines, Tables, Drawn),
    maplist(laid, Things, Drawn, Places, Laid),
    laid_sheets(Laid, Sheets).

%   layout_tables(Ds, Options, Paper, Tables): where a sheet is tiled they have
%   pages of their own (table_pages/3).

layout_tables(Ds, Options, Paper, Tables) :-
    (   option(tile(true), Options)
    ->  Tables = []
    ;   pattern_tables(Ds, Options, Paper, Tables)
    ).

named_table(Table, table(D,I)-Loops) :-
    Table = table(D, I, _, _),
    table_loops(Table, Loops).

%   What found no place has a sheet of its own, and goes beyond it.

placed_all(Loops, Places0, Places) :-
    findall(I, ( nth1(I, Places0, _-Place), Place = place(0,_,_,_) ), Large),
    (   Large == []
    ->  Places = Places0
    ;   length(Large, N),
        print_message(warning, sanggwan(pattern(too_large(N)))),
        foldl(own_sheet, Loops, Places0, Places, 1000000, _)
    ).

own_sheet(_-[Loop|_], Name-place(0,_,_,_), Place, I0, I) :-
    !,
    I is I0+1,
    findall(X, member(X-_, Loop), Xs),
    findall(Y, member(_-Y, Loop), Ys),
    min_list(Xs, X0),
    min_list(Ys, Y0),
    DX is -X0,
    DY is -Y0,
    Place = Name-place(I,0.0,DX,DY).
own_sheet(_, Place, Place, I, I).

pieces_of(Look, D, Pieces) :-
    pattern_pieces(D, Look, Pieces).

factor(Options, Factor) :-
    option(scale(Scale), Options, 1:1),
    option(unit(Unit), Options, mm),
    (   unit_millimetres(Unit, Millimetres)
    ->  true
    ;   domain_error(unit, Unit)
    ),
    (   Scale = N:M
    ->  Factor is Millimetres*N/M
    ;   Factor is Millimetres*Scale
    ),
    (   Factor > 0
    ->  true
    ;   domain_error(scale, Scale)
    ).

%   has_area(Piece): there is something to cut out.

has_area(piece(_,Faces,_)) :-
    member(face(_,[_|_]), Faces),
    !.

%   pieces_points(Pieces, Pointss): the corners of each shape of their faces.

pieces_points(Pieces, Pointss) :-
    findall(Points,
            ( member(piece(_,Faces,_), Pieces),
              member(face(_,Shapes), Faces),
              member(Shape, Shapes),
              pairs_values(Shape, Points) ),
            Pointss).

%   least_pages(Pointss, Paper, Count): by area fewer than Count do not do.

least_pages(_, roll(_), 1).
least_pages(Pointss, room(W,H,_), Count) :-
    maplist(loop_area, Pointss, Areas),
    sum_list(Areas, All),
    Count is max(1, ceiling(All/(W*H))).

fitted_parts(fitted(Piece,Outline), Piece, Outline).

named_loops(piece(Name,_,_), Outline, Name-Loops) :-
    outline_loops(Outline, Loops).

laid(Piece, Outline, _-Place, laid(Piece,Outline,Place)).

laid_sheets(Laid, Sheets) :-
    maplist(sheet_number, Laid, Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    pairs_values(Groups, Sheets).

sheet_number(Laid, I-Laid) :-
    Laid = laid(_, _, place(I,_,_,_)).


                /*******************************
                *           DRAWING            *
                *******************************/

layout_drawings(Layout, Options0, Drawings) :-
    Layout = layout(_, _, Sheets, Numbers, _, _),
    length(Sheets, Count),
    findall(Name-I,
            ( nth1(I, Sheets, Laid),
              member(laid(piece(Name,_,_),_,_), Laid)
            ),
            On),
    partner_sheets(Numbers, On, Partners),
    Options = [partner_sheets(Partners)|Options0],
    numbered(Sheets, 1, Numbered),
    maplist(sheet_drawing(Layout, Options, Count), Numbered, Drawings,
            Skippeds),
    append(Skippeds, Skipped),
    told_skipped(Skipped).

numbered([], _, []).
numbered([X|Xs], I, [I-X|Numbered]) :-
    I1 is I+1,
    numbered(Xs, I1, Numbered).

told_skipped(Skipped) :-
    findall(Role, member(Role-_, Skipped), Roles0),
    sort(Roles0, Roles),
    forall(member(Role, Roles),
           ( findall(N, member(Role-N, Skipped), Ns),
             sum_list(Ns, Sum),
             print_message(informational,
                           sanggwan(pattern(no_room(Role,Sum)))) )).

sheet_drawing(Layout, Options, Count, I-Laid, Drawing, Skipped) :-
    Layout = layout(Factor, Sheet, _, Numbers, Tabs, Butt),
    Sheet = sheet(Width, Height, _, _, _, _),
    option(fold_threshold(Threshold), Options, 0.5),
    How = how(Threshold, Butt),
    partition(is_laid_piece, Laid, LaidPieces, LaidTables),
    maplist(placed_piece(Sheet, Tabs, How), LaidPieces, Placed),
    maplist(table_view(Sheet), LaidTables, Tables),
    findall([A,B], ( member(placed(_,_,Loops,_,_), Placed),
                     member(Loop, Loops), member(edge(_,A,B), Loop) ), Cuts),
    findall([A,B], ( member(placed(_,_,_,Lines,_), Placed),
                     member(line(_,_,A,B), Lines) ), Folds),
    maplist(wanted_texts(Options, Numbers), Placed, Wanteds),
    append(Wanteds, Wanted),
    written(Cuts, Folds, Wanted, Letters, Skipped),
    letters_by_piece(Letters, ByPiece),
    option(kerf(Kerf), Options, 0),
    maplist(piece_view(Height, Kerf, ByPiece), Placed, Views),
    sheet_view(Sheet, Options, Count-I, Views0),
    append([Views0,Views,Tables], All),
    W is round(Width*1000),
    H is round(Height*1000),
    Drawing = drawing(sheet(W,H,Factor), All).

is_laid_piece(laid(piece(_,_,_),_,_)).

%   placed(Name, Faces, Loops, Lines, Sides): a piece in millimetres of its
%   sheet, y up. Loops are lists of edge(E,A,B), Lines line(Role,E,A,B); Sides
%   as in pattern_piece.pl.

placed_piece(Sheet, Tabs, How, laid(Piece,Outline,Place),
             placed(Name,Faces,Loops,Lines,Sides)) :-
    Piece = piece(Name, Faces0, Sides0),
    sheet_move(Sheet, Place, Move),
    findall(Loop, ( member(Ways, Outline),
                    findall(Edge, way_edge(Ways, Move, Edge), Loop) ),
            Loops0),
    findall(line(Role,E,A,B),
            ( piece_line(Piece, Tabs, How, line(Role,E,A0,B0)),
              moved(Move, A0, A),
              moved(Move, B0, B)
            ),
            Lines0),
    parted(Loops0, Lines0, Loops, Lines),
    maplist(moved_side(Move), Sides0, Sides),
    maplist(moved_face(Move), Faces0, Faces).

%   parted(Loops0, Lines0, Loops, Lines): what lies on each other in part, as
%   in slits that have closed, is parted, so that it is known as the same.

parted(Loops0, Lines0, Loops, Lines) :-
    findall(A-B,
            (   member(Loop, Loops0), member(edge(_,A,B), Loop)
            ;   member(line(_,_,A,B), Lines0)
            ),
            Segments),
    parted_segments(Segments, Partss),
    foldl(parted_loop, Loops0, Partss-Loops, Partss1-[]),
    foldl(parted_line, Lines0, Partss1-Lines, []-[]).

parted_loop(Loop0, Partss0-[Loop|Loops], Partss-Loops) :-
    foldl(parted_edge, Loop0, Partss0-Loop, Partss-[]).

parted_edge(edge(E,_,_), [Parts|Partss]-Edges0, Partss-Edges) :-
    findall(edge(E,A,B), member(A-B, Parts), Edges0, Edges).

parted_line(line(Role,E,_,_), [Parts|Partss]-Lines0, Partss-Lines) :-
    findall(line(Role,E,A,B), member(A-B, Parts), Lines0, Lines).

way_edge(Ways, Move, edge(E,A,B)) :-
    member(way(E,Points), Ways),
    append(_, [A0,B0|_], Points),
    moved(Move, A0, A),
    moved(Move, B0, B).

moved_side(Move, side(E,P,WA-A0,WB-B0,Joint), side(E,P,WA-A,WB-B,Joint)) :-
    moved(Move, A0, A),
    moved(Move, B0, B).

moved_face(Move, face(P,Shapes0), face(P,Shapes)) :-
    maplist(moved_shape(Move), Shapes0, Shapes).

moved_shape(Move, Shape0, Shape) :-
    maplist(moved_corner(Move), Shape0, Shape).

moved_corner(Move, _-P0, P) :-
    moved(Move, P0, P).

%   The grid, and the check bar with what the sheet is; where it is tiled each
%   page has a bar of its own.

sheet_view(Sheet, Options, Count-I, Views) :-
    findall(Line, line_beside(Sheet, Options, Count-I, Line), Lines),
    Sheet = sheet(_, Height, _, _, _, _),
    line_strokes(Lines, Height, Strokes, Texts),
    (   Strokes == []
    ->  Views = []
    ;   Views = [view(sheet,Strokes,Texts)]
    ).

line_beside(Sheet, Options, _, Line) :-
    option(grid(Step), Options),
    number(Step),
    Step > 0,
    grid_line(Step, Sheet, Line).
line_beside(Sheet, Options, Count-I, Line) :-
    \+ option(tile(true), Options),
    sheet_says(Options, Count, I, Says),
    sheet_line(Sheet, Options, Says, Line).

sheet_says(Options, Count, I, Says) :-
    findall(Say, sheet_word(Options, Count, I, Say), Says).

sheet_word(Options, _, _, Say) :-
    option(title(Title), Options),
    text_to_string(Title, Say),
    Say \== "".
sheet_word(Options, _, _, Say) :-
    option(scale(Scale), Options, 1:1),
    scale_text(Scale, Say).
sheet_word(_, Count, I, Say) :-
    Count > 1,
    format(string(Say), '~d/~d', [I,Count]).
