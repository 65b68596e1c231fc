:- encoding(utf8).
:- module(test_pattern_drawing, []).
% covers: pattern_fit, pattern_join, pattern_lines, pattern_paper
% covers: pattern_tab, pattern_table, pattern_view, pattern_word
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(yall)).
:- use_module(rules(store)).
:- use_module(rules(decision), [use_rules/1]).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(unrolling/true_development), [true_development/4]).
:- use_module(rules(pattern/pattern_number), [reads_turned/1]).
:- use_module(rules(sheet/lettering), [lettering_width/3]).
:- use_module(rules(pattern/pattern_outline), [cut_loops/2]).
:- use_module(rules(pattern/pattern_text), [written/5]).
:- use_module(rules(pattern/pattern_word), [word_lines/3]).
:- use_module(tests('rules/pattern/pattern_case')).
:- use_module(tests('rules/pattern/cut_checked')).

:- meta_predicate in_new(0).

in_new(Goal) :-
    new_world(World),
    in_world(World, Goal).

% The drawings of a pattern made by Goal.
:- meta_predicate drawn(0, +, -).

drawn(Goal, Options, Drawings) :-
    in_new(( call(Goal), quietly(pattern_drawing([2], Options, Drawings)) )).

:- meta_predicate quietly(0).

quietly(Goal) :-
    setup_call_cleanup(
        asserta((user:message_hook(_, Kind, _) :-
                     memberchk(Kind, [warning,informational])), Ref),
        Goal,
        erase(Ref)).

stroke(Drawings, Role, Stroke) :-
    member(drawing(_,Views), Drawings),
    member(view(_,Strokes,_), Views),
    member(Stroke, Strokes),
    Stroke = stroke(_, Role, _, _, _, _, _).

count(Drawings, Role, N) :-
    findall(x, stroke(Drawings, Role, _), Xs),
    length(Xs, N).

length_of(Points, Length) :-
    findall(L, ( append(_, [XA-YA,XB-YB|_], Points),
                 L is sqrt((XB-XA)**2+(YB-YA)**2) ), Ls),
    sum_list(Ls, Length).

right(Drawings) :-
    forall(member(Drawing, Drawings),
           ( cut_fault(Drawing, Fault)
           ->  print_message(error, format("~q", [Fault])), fail
           ;   true )).

slit_pattern :-
    pattern_from_faces([face(1, [1,2,3,4],   [0-0,40-0,40-10,0-10], 1),
                        face(2, [2,5,6,3],   [40-0,50-0,50-10,40-10], 1),
                        face(3, [3,6,7,8],   [40-10,50-10,50-30,40-30], 1),
                        face(4, [9,3,8,10],  [20-10,40-10,40-30,20-30], 1),
                        face(5, [4,9,10,12], [0-10,20-10,20-30,0-30], 1)]).

% The height of capitals of a name in the middle of Face, between two numbers
% that leave it Gap more than its letters at either side.
number_beside_name(Gap, Face, Height) :-
    lettering_width("HHH", 6.0, Width),
    Left is 20-Width/2-Gap,
    Right is 20+Width/2+Gap,
    written([[Left-0.0,Left-20.0],[Right-0.0,Right-20.0]], [],
            [want(face_name,p,"HHH",[6.0,4.5],within([Face]))],
            [letters(face_name,p,[],Word)], []),
    word_lines(0, Word, Lines),
    findall(Y, ( member(Points, Lines), member(_-Y, Points) ), Ys),
    min_list(Ys, Low),
    max_list(Ys, High),
    Height is round((High-Low)/100)/10.0.

% The numbers of partners on each sheet I, N-Sheet, where Sheet is 0 if none is
% said.
partner_number(Drawings, I, N, Sheet) :-
    nth1(I, Drawings, drawing(_,Views)),
    member(view(_,_,Texts), Views),
    member(word(number,_,_,text(_,_,_,_,Text),_), Texts),
    (   split_string(Text, "p", " ", [NText,SheetText])
    ->  number_string(Sheet, SheetText)
    ;   NText = Text,
        Sheet = 0
    ),
    number_string(N, NText).

middle(Strokes, X-Y) :-
    findall(P, ( member(stroke(_,_,_,_,Ps,_,_), Strokes), member(P, Ps) ), All),
    findall(PX, member(PX-_, All), Xs),
    findall(PY, member(_-PY, All), Ys),
    maplist(extent, [Xs,Ys], [X,Y]).

extent(Ns, Middle) :-
    min_list(Ns, Low),
    max_list(Ns, High),
    Middle is (Low+High)/2.

% The middle of letters is half their height above the middle of their line.
above_by_half(Angle, DX, DY, High) :-
    Up is -DX*sin(Angle*pi/180) + DY*cos(Angle*pi/180),
    Along is DX*cos(Angle*pi/180) + DY*sin(Angle*pi/180),
    abs(Up-High/2) < High/20,
    abs(Along) < High/2.

% The sides seam(J,Which) of a cube that have tabs; turn_of(J, I): J is the I-th
% seam whose first side one comes to round the piece.
:- dynamic turn_of/2.

tab_seams(On, Sided) :-
    in_new(( call(cube_pattern(40)),
             quietly(pattern_layout([2], [tabs(6),tab_sides(On)],
                                    layout(_,_,Sheets,_,Tabs,_))) )),
    Sheets = [[laid(piece(_,_,Sides),_,_)]],
    retractall(turn_of(_, _)),
    cut_loops(Sides, [Loop]),
    forall(nth1(I, Loop, side(_,_,_,_,seam(J,_,1))), assertz(turn_of(J, I))),
    findall(seam(J,Which),
            ( member(side(E,_,A-_,B-_,seam(J,_,Which)), Sides),
              get_assoc(tab(2,E,A,B), Tabs, _) ),
            Sided).

:- begin_tests(pattern_drawing).

test(roles, [ N-Folds == 1-5 ]) :-
    drawn(cube_pattern(40), [], Drawings),
    count(Drawings, cut, N),
    count(Drawings, fold_down, Folds).
test(outline_closes) :-
    drawn(cube_pattern(40), [], Drawings),
    stroke(Drawings, cut, stroke(_,_,_,_,Points,End,_)),
    length_of(Points, Length0),
    Length is round(Length0),
    !,
    assertion(End == ring),
    assertion(Length =:= 560000).
test(an_edge_for_each_side, [ true(L =:= N) ]) :-
    drawn(cube_pattern(40), [tabs(6)], Drawings),
    stroke(Drawings, cut, stroke(_,_,2,Edges,Points,_,_)),
    length(Edges, L),
    length(Points, M),
    N is M-1,
    !.
test(true_scale, [ Lengths == [20000] ]) :-
    drawn(cube_pattern(40), [scale(1:2)], Drawings),
    findall(L, ( stroke(Drawings, fold_down, stroke(_,_,_,_,Ps,_,_)),
                 length_of(Ps, L0), L is round(L0) ), Ls),
    sort(Ls, Lengths).
test(unit, [ Lengths == [400000] ]) :-
    drawn(cube_pattern(40), [unit(cm)], Drawings),
    findall(L, ( stroke(Drawings, fold_down, stroke(_,_,_,_,Ps,_,_)),
                 length_of(Ps, L0), L is round(L0) ), Ls),
    sort(Ls, Lengths).
test(a_bar_of_100_mm, [ true(Longest =:= 100000) ]) :-
    drawn(cube_pattern(40), [page('A4'), scale(1:2)], Drawings),
    findall(L, ( stroke(Drawings, bar, stroke(_,_,_,_,Ps,_,_)),
                 length_of(Ps, L0), L is round(L0) ), Ls),
    max_list(Ls, Longest).
test(page_size, [ Sizes == [215900-279400] ]) :-
    drawn(cube_pattern(40), [page(letter)], Drawings),
    findall(W-H, member(drawing(sheet(W,H,_),_), Drawings), Sizes).
test(numbers_on_both_sides) :-
    drawn(cube_pattern(40), [], Drawings),
    drawn(cube_pattern(40), [numbers(false)], Without),
    count(Drawings, number, N),
    assertion(N >= 14),
    assertion(count(Without, number, 0)).
% 24 facets are one seam, but for where a circle hangs on it.
test(a_curve_has_one_number, [ Counts == [1,1,1,1,1] ]) :-
    in_new(( tmp_file_stream(File, Out, [extension(pl)]),
             format(Out, 'segment(1, solid, cylinder(radius(20), height(60), \c
                          facets(24))).~n', []),
             close(Out),
             load_model(File),
             develop(1, D),
             pattern_layout([D], [], layout(_,_,_,Numbers,_,_)) )),
    assoc_to_values(Numbers, [Strands]),
    findall(N, member(N-_, Strands), Ns0),
    msort(Ns0, Ns),
    findall(C, ( between(1, 5, N), findall(x, member(N, Ns), Xs),
                 length(Xs, C0), C is C0//2 ), Counts).
% 6 turned upside down is 9, 68 is 89; 69 is itself, 60 would be 09.
test(read_turned, [ Ns == [6,9,16,18,19,61,66,68,81,86,89,91,98,99] ]) :-
    findall(N, ( between(1, 100, N), reads_turned(N) ), Ns).
test(read_turned_long) :-
    assertion(reads_turned(109)),       % 601
    assertion(\+ reads_turned(1001)).
test(underlined, [ true(Line-Below == 50.0-true) ]) :-
    Face = [0.0-0.0,100.0-0.0,100.0-100.0,0.0-100.0],
    written([], [], [want(number,p,underlined("68"),[10.0],within([Face]))],
            [letters(number,p,[[XA-YA,XB-YA]],Word)], []),
    word_lines(0, Word, Lines),
    Line is (XA+XB)/2,
    (   forall(( member(Points, Lines), member(_-Y, Points) ), -Y/1000 > YA+2)
    ->  Below = true
    ;   Below = false
    ).
test(not_underlined, [ Under == [] ]) :-
    Face = [0.0-0.0,100.0-0.0,100.0-100.0,0.0-100.0],
    written([], [], [want(number,p,"7",[10.0],within([Face]))],
            [letters(number,p,Under,_)], []).
% A slit has closed: one long side lies on two short ones. 160 mm are round the
% piece, and 40 in it, once.
test(no_part_is_cut_twice, [ Length =:= 200000 ]) :-
    drawn(slit_pattern, [numbers(false)], [Drawing]),
    assertion(right([Drawing])),
    findall(L, ( stroke([Drawing], cut, stroke(_,_,_,_,Points,_,_)),
                 length_of(Points, L) ), Ls),
    sum_list(Ls, Length0),
    Length is round(Length0/100)*100.
% Names end well before a number beside them: `face 6` and 2 are not face 62.
test(names_apart_from_numbers, [ Heights == [6.0,4.5] ]) :-
    Face = [0.0-0.0,40.0-0.0,40.0-20.0,0.0-20.0],
    findall(Height,
            ( member(Gap, [4.0,2.0]),
              number_beside_name(Gap, Face, Height) ),
            Heights).
% A number that names a sheet has its partner there, which names the first; one
% with both sides on its sheet names none.
test(sheet_of_the_partner, [true(Named > 10)]) :-
    drawn(cube_pattern(150), [page('A4'),tabs(8)], Drawings),
    findall(N-(I-Sheet), partner_number(Drawings, I, N, Sheet), All),
    assertion(forall(member(N-(I-0), All),
                     \+ ( member(N-(J-_), All), J =\= I ))),
    assertion(forall(( member(N-(I-Sheet), All), Sheet > 0 ),
                     memberchk(N-(Sheet-I), All))),
    include([_-(_-Sheet)]>>( Sheet > 0 ), All, Others),
    length(Others, Named).
% A tail that reaches below the line is a part of the text.
test(tails_keep_clear, [ true(Least > 10.0) ]) :-
    Line = [0.0-10.0,100.0-10.0],
    Face = [0.0-10.0,100.0-10.0,100.0-19.0,0.0-19.0],
    written([Line], [], [want(face_name,p,"gyp",[6.0],within([Face]))],
            [letters(face_name,p,[],Word)], []),
    word_lines(0, Word, Lines),
    findall(Y, ( member(Points, Lines), member(_-Y0, Points), Y is -Y0/1000 ),
            Ys),
    min_list(Ys, Least).
% Each word is a text as well, at the middle of what its strokes reach, and
% reads along their direction.
test(words_are_their_strokes, [ Angles == [0,90,180,270] ]) :-
    drawn(cube_pattern(40), [page('A4')], Drawings),
    findall(Angle,
            ( member(drawing(_,Views), Drawings),
              member(view(_,Strokes,Texts), Views),
              member(word(number,_,Angle0,text(X,Y,High,middle,_),Own), Texts),
              assertion(( Own \== [], subset(Own, Strokes) )),
              middle(Own, XM-YM),
              Angle is Angle0//1000,
              assertion(above_by_half(Angle, XM-X, Y-YM, High))
            ),
            Angles0),
    sort(Angles0, Angles).
% Between an edge and its number nothing is cut: at the tip of a needle the
% number would stand beside it.
test(not_beyond_a_needle, [ Skipped == [number-1] ]) :-
    A = 0.0-0.0,
    B = 6.0-0.0,
    written([[A,B],[B,0.0-0.4],[0.0-0.4,A]], [],
            [want(number,p,"7",[2.0,1.6],beside([A-B]))], [], Skipped).
% What finds no room between folds is written over them, but over no cut.
test(over_folds, [ Found-Skipped == 1-[number-1] ]) :-
    findall([X-0.0,X-10.0], between(0, 20, X), Folds),
    A = 10.0-0.0,
    B = 11.0-0.0,
    Long = (0.0-0.0)-(20.0-0.0),
    Want = want(number,p,"22",[2.0,1.6],
                first_of([beside([A-B]),over_folds(beside([Long]))])),
    written([], Folds, [Want], Letters, []),
    written(Folds, [], [Want], [], Skipped),
    length(Letters, Found).
test(inside_folds_up, [ Up-Down == 5-0 ]) :-
    drawn(cube_pattern(40), [inside(true)], Drawings),
    count(Drawings, fold_up, Up),
    count(Drawings, fold_down, Down).
test(inside_is_mirrored) :-
    forall(member(Inside, [true,false]),
           ( drawn(cube_pattern(40), [inside(Inside),tabs(5)], Drawings),
             assertion(right(Drawings)) )).
test(flat_folds_are_hidden, [ N == 0 ]) :-
    drawn(cube_pattern(40), [fold_threshold(95)], Drawings),
    count(Drawings, fold_down, N).
test(angles, [ true(N > 5) ]) :-
    drawn(cube_pattern(40), [angles(true)], Drawings),
    count(Drawings, angle, N).
test(grid, [ true(N > 10) ]) :-
    drawn(cube_pattern(40), [grid(10)], Drawings),
    count(Drawings, grid, N).

% 7 seams, 7 tabs: a fold for each.
test(tabs, [ N == 12 ]) :-
    drawn(cube_pattern(40), [tabs(8)], Drawings),
    count(Drawings, fold_down, N),
    assertion(right(Drawings)).
test(tabs_wider_than_there_is_room) :-
    forall(member(Width, [1,5,15,30,80]),
           ( drawn(cube_pattern(40), [tabs(Width)], Drawings),
             assertion(right(Drawings)) )).

test(divided_at_folds, [ Sheets-Seams == 2-4 ]) :-
    drawn(strip_pattern(12, 40, 100), [page('A4'),tabs(7)], Drawings),
    length(Drawings, Sheets),
    assertion(right(Drawings)),
    % 11 folds, one of them a seam now; two tabs fold
    count(Drawings, fold_down, Folds),
    Seams is 2*(12-Folds+2) .
test(divided_along_lines) :-
    forall(member(W-H-N, [400-300-4, 900-300-8, 480-100-2]),
           ( drawn(plate_pattern(W, H), [page('A4'),tabs(7)], Drawings),
             assertion(right(Drawings)),
             findall(x, ( member(drawing(_,Views), Drawings),
                          member(view(Name,_,_), Views),
                          Name \== sheet ), Xs),
             length(Xs, Parts),
             assertion(Parts =:= N) )).
% Faces that are all longer than the page: their halves are connected.
test(divided_both_ways, [ Parts-Folds == 2-20 ]) :-
    drawn(strip_pattern(11, 15, 400), [page('A4')], Drawings),
    assertion(right(Drawings)),
    findall(x, ( member(drawing(_,Views), Drawings),
                 member(view(Name,_,_), Views),
                 Name \== sheet ), Xs),
    length(Xs, Parts),
    count(Drawings, fold_down, Folds).
% Each new side is there twice, as long on both sides, so that the marks at a
% quarter and three quarters of it lie on each other.
test(divided_sides_fit, [ forall(member(W-H, [400-300, 900-300, 480-100])) ]) :-
    in_new(( plate_pattern(W, H), divided_sides([page('A4')], Groups) )),
    assertion(Groups \== []),
    forall(member(_-Lengths, Groups), assertion(same_two(Lengths))).
test(divided_solids_fit,
     [ forall(member(Term-Scale,
                     [ box(size(40,30,25))-(10:1),
                       hollow_cylinder(radius(30),inner(20),height(50),
                                       facets(24))-(12:1),
                       prism(outline([[0,0],[50,0],[60,20],[30,15],[40,60]]),
                             height(20))-(9:1)
                     ])) ]) :-
    in_new(( add_primitive(Term, S),
             develop(S, D),
             quietly(divided_sides_of(D, [page('A4'),tabs(6),scale(Scale)],
                                      Groups)) )),
    assertion(Groups \== []),
    forall(member(_-Lengths, Groups), assertion(same_two(Lengths))).
test(divided_area) :-
    drawn(plate_pattern(400, 300), [page('A4')], Drawings),
    findall(A, ( stroke(Drawings, cut, stroke(_,_,_,_,Ps,_,_)),
                 area(Ps, A) ), As),
    sum_list(As, Area),
    assertion(abs(Area-400*300*1.0e6) < 1.0e6).

test(tiled, [ Names == ['page-A1','page-B1','page-C1'] ]) :-
    drawn(strip_pattern(12, 40, 100), [page('A4'),tile(true)], Drawings),
    findall(Name, ( member(drawing(_,Views), Drawings),
                    member(view(Name,_,_), Views),
                    sub_atom(Name, 0, _, _, 'page-') ), Names).
% A table is on pages of its own, or in parts; each has its lines on one sheet.
test(tables_are_whole, [ forall(member(Options-Least,
                                       [ [tile(true)]-2,
                                         [page('A4')]-2,
                                         [page('A4'),tile(true)]-2,
                                         []-1 ])) ]) :-
    in_new(( developed_pipe(120, D),
             quietly(pattern_drawing([D], Options, Drawings)) )),
    findall(Name, table_view(Drawings, Name, _, _), Names0),
    sort(Names0, Names),
    length(Names, Parts),
    assertion(same_length(Names0, Names)),
    assertion(Parts >= Least),
    findall(Ys, ( table_view(Drawings, _, Sheet, Strokes),
                  assertion(closed_frame(Strokes)),
                  assertion(on_sheet(Sheet, Strokes)),
                  rows_of(Strokes, Ys) ), Yss),
    sum_list(Yss, Rows),
    assertion(Rows =:= 121+Parts).
test(same_again) :-
    drawn(strip_pattern(12, 40, 100), [page('A4'),tabs(7),names(true)], A),
    drawn(strip_pattern(12, 40, 100), [page('A4'),tabs(7),names(true)], B),
    assertion(A == B).
% The rule of docs/patterns.md.
test(tab_rule, [ true(Deepest =< 4.001) ]) :-
    tmp_file_stream(File, Out, [extension(pl)]),
    format(Out, 'tab_shape(Width, Length, Shape, Area) :-~n\c
                 Narrow is min(4.0, Width),~n\c
                 default(tab_shape(Narrow, Length, Shape, Area)),~n\c
                 Shape = tab(_, Run, _, Run, _).~n', []),
    close(Out),
    in_new(( use_rules(File),
             cube_pattern(40),
             pattern_layout([2], [tabs(9)], layout(_,_,_,_,Tabs,_)) )),
    assoc_to_values(Tabs, Own),
    append(Own, Points),
    maplist(deep, Points, Deeps),
    max_list(Deeps, Deepest).

deep([XA-YA,XB-YB,_,XD-YD], Deep) :-
    Deep is abs((XD-XA)*(YB-YA) - (YD-YA)*(XB-XA))
            / sqrt((XD-XA)**2 + (YD-YA)**2).

test(nothing, [ Count == 0 ]) :-
    in_new(( assert_fact(segment(2, pattern, nothing)),
             pattern_drawing([2], [], Drawings) )),
    count(Drawings, cut, Count).
test(no_area, [ Count == 0 ]) :-
    in_new(( assert_fact(segment(1, surface, needle)),
             forall(between(1, 3, V),
                    ( X is float(V), assert_fact(v(1, V, X, 0.0, 0.0)) )),
             forall(between(1, 3, E),
                    ( B is E mod 3 + 1, assert_fact(e(1, E, E, B, 1)) )),
             assert_fact(p(1, 1, [1,2,3])),
             quietly(( develop(1, D), pattern_drawing([D], [], Drawings) )) )),
    count(Drawings, cut, Count).
test(many_pages, [ error(usage_error(pattern(pages(_, 5000)))) ]) :-
    drawn(cube_pattern(40), [page('A4'),scale(1000:1)], _).
test(many_tiles, [ error(usage_error(pattern(pages(_, 5000)))) ]) :-
    drawn(cube_pattern(40), [page('A4'),scale(1000:1),tile(true)], _).
test(large, [ error(usage_error(pattern(large(_, _)))) ]) :-
    drawn(cube_pattern(1.0e13), [], _).
% Tabs are no deeper than short seams let them; long ones on a page have limits.
test(very_wide_tabs) :-
    drawn(cube_pattern(40), [page('A4'),tabs(500)], Drawings),
    assertion(right(Drawings)),
    count(Drawings, fold_down, N),
    assertion(N =:= 12).
test(too_wide_tabs,
     error(usage_error(pattern(wide('--tabs', 500, 47, _))))) :-
    drawn(plate_strip, [page('A4'),tabs(500)], _).
% A quarter of 188 mm may go to each side; a lock seam adds one and a half times
% its width to it.
test(widest_joints) :-
    forall(member(Joint-Option-Most, [tabs-'--tabs'-47, lap-'--lap'-47,
                                      lock-'--lock-seam'-31]),
           ( Fits =.. [Joint,Most],
             drawn(plate_strip, [page('A4'),margin(11),Fits], Drawings),
             assertion(right(Drawings)),
             Wider is Most+1,
             Large =.. [Joint,Wider],
             catch(drawn(plate_strip, [page('A4'),margin(11),Large], _),
                   error(E, _), true),
             assertion(E = usage_error(pattern(wide(Option, Wider, Most,
                                                    188.0-_)))) )).
% Of 190 x 268 mm a lap of 5 leaves four faces of 44 beside each other, and a
% third of these heights.
test(room_for_laps, [ forall(member(High, [520,530])), Parts == 6 ]) :-
    drawn(strip_pattern(8, 44, High), [page('A4'),lap(5)], Drawings),
    assertion(right(Drawings)),
    findall(x, ( member(drawing(_,Views), Drawings),
                 member(view(Name,_,_), Views),
                 Name \== sheet ), Xs),
    length(Xs, Parts).
test(whole_with_its_tabs, [ Sheets == 1 ]) :-
    drawn(cube_pattern(55), [page('A4'),tabs(12)], Drawings),
    length(Drawings, Sheets).
test(no_room, [ error(usage_error(pattern(margin(200, _)))) ]) :-
    drawn(cube_pattern(40), [page('A4'),margin(200)], _).
test(wide_overlap, [ error(usage_error(pattern(overlap(100, 95.0)))) ]) :-
    drawn(cube_pattern(40), [tile(true),overlap(100)], _).
test(no_page, [ error(usage_error(pattern(paper('B9',_)))) ]) :-
    drawn(cube_pattern(40), [page('B9')], _).

divided_sides(Options, Groups) :-
    quietly(divided_sides_of(2, Options, Groups)).

divided_sides_of(D, Options, Groups) :-
    pattern_layout([D], Options, layout(_,_,Sheets,_,_,_)),
    findall(J-L,
            ( member(Sheet, Sheets),
              member(laid(piece(_,_,Sides),_,_), Sheet),
              member(side(_,_,_-(XA-YA),_-(XB-YB),seam(J,_,_)), Sides),
              J = split(_,_),
              L is sqrt((XB-XA)**2 + (YB-YA)**2)
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups).

same_two([A,B]) :-
    abs(A-B) < 1.0e-9*A.

developed_pipe(N, D) :-
    add_primitive(cylinder(radius(20), height(80), facets(24)), S),
    true_development(S, _, [generators(N)], D).

table_view(Drawings, Name, Sheet, Strokes) :-
    member(drawing(Sheet,Views), Drawings),
    member(view(Name,Strokes,_), Views),
    sub_atom(Name, 0, _, _, table).

on_sheet(sheet(W,H,_), Strokes) :-
    forall(( member(stroke(_,_,_,_,Points,_,_), Strokes),
             member(X-Y, Points) ),
           ( X >= 0, X =< W, Y >= 0, Y =< H )).

% The four corners of the frame are ends of lines each.
closed_frame(Strokes) :-
    findall(P, ( member(stroke(_,_,_,_,[A,B],_,_), Strokes),
                 ( P = A ; P = B ) ), Ends),
    findall(X, member(X-_, Ends), Xs),
    findall(Y, member(_-Y, Ends), Ys),
    min_list(Xs, X0), max_list(Xs, X1),
    min_list(Ys, Y0), max_list(Ys, Y1),
    forall(( member(X, [X0,X1]), member(Y, [Y0,Y1]) ),
           ( append(_, [X-Y|Rest], Ends), memberchk(X-Y, Rest) )).

% 9 columns have 10 lines, the others are those of rows: it may lie on its side.
% Letters are lines too, but short.
rows_of(Strokes, Rows) :-
    findall(A-B, member(stroke(_,_,_,_,[A,B],_,_), Strokes), Lines),
    findall(x, ( member((X-YA)-(X-YB), Lines), abs(YA-YB) > 20000 ), Ups),
    findall(x, ( member((XA-Y)-(XB-Y), Lines), abs(XA-XB) > 20000 ), Across),
    length(Ups, U),
    length(Across, A),
    Rows is max(U, A)-1.

plate_strip :-
    strip_pattern(12, 40, 400).

area(Points, Area) :-
    findall(A, ( append(_, [XA-YA,XB-YB|_], Points),
                 A is (XA*YB-XB*YA)/2 ), As),
    sum_list(As, Area0),
    Area is abs(Area0).

% A box of triangles, larger than the page, is parted between its faces and
% along straight lines, never along a diagonal of a face.
test(no_cut_along_a_diagonal, [true(Cuts > 0)]) :-
    in_new(( Faces = [[1,3,2],[1,4,3],[5,6,7],[5,7,8],[1,2,6],[1,6,5],
                      [2,3,7],[2,7,6],[3,4,8],[3,8,7],[4,1,5],[4,5,8]],
             Places = [[0,0,0],[300,0,0],[300,200,0],[0,200,0],
                       [0,0,90],[300,0,90],[300,200,90],[0,200,90]],
             add_primitive(polyhedron(points(Places), faces(Faces)), S),
             develop(S, D),
             quietly(pattern_layout([D], [page('A4')],
                                    layout(_,_,Sheets,_,_,_))) )),
    findall(J-Angle,
            ( member(Laid, Sheets),
              member(laid(piece(_,_,Sides),_,_), Laid),
              member(side(_,_,_,_,seam(J,Angle,_)), Sides)
            ),
            Seams),
    assertion(\+ ( member(J-Angle, Seams), integer(J), abs(Angle) < 1 )),
    aggregate_all(count, member(split(_,_)-_, Seams), Cuts).

% The seven seams of a cube have a tab each, or two, or one each on the sides in
% turn: of any two that follow each other round the piece one has it.
test(tab_sides, Counts == [7,14,7]) :-
    findall(Count,
            ( member(On, [one,both,alternate]),
              tab_seams(On, Sided),
              length(Sided, Count) ),
            Counts).
test(tabs_in_turn, [true(Turns >= 5)]) :-
    tab_seams(alternate, Sided),
    findall(I-Which, ( member(seam(J,Which), Sided), turn_of(J, I) ), Pairs0),
    sort(Pairs0, Pairs),
    aggregate_all(count, append(_, [_-A,_-B|_], Pairs), Pairs1),
    assertion(Pairs1 == 6),
    aggregate_all(count, ( append(_, [_-A,_-B|_], Pairs), A =\= B ), Turns).

:- end_tests(pattern_drawing).
