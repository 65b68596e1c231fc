:- encoding(utf8).
:- module(test_sheet_plan, []).
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(sheet/sheet_plan)).
:- use_module(rules(command/sheet_options)).
:- use_module(tests('rules/sheet/sheet_of'), [sheet_of/3]).
:- use_module(rules(sheet/sheet_words)).
:- use_module(rules(message/sheet_en)).
:- use_module(rules(csg/csg_roots), [roots_alone/0]).
:- use_module(rules(drawing/drawing), [write_drawing_stream/3]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(command/verbs), [draw/2]).
:- use_module(tests('rules/sample')).

% The drawing of a model of facts/ by options as on the command line.
drawn_sheet(Model, Options, Drawing) :-
    atomic_list_concat(['facts/',Model,'.pl'], Path),
    absolute_file_name(sanggwan(Path), File),
    sheet_of(File, Options, Drawing).

drawing_view(drawing(_,Views), Name, Strokes, Texts) :-
    memberchk(view(Name,Strokes,Texts), Views).

% X and Y of the ends of visible lines of the model in a view.
model_points(Drawing, Name, Points) :-
    drawing_view(Drawing, Name, Strokes, _),
    findall(P, ( member(stroke(_,_,S,[_|_],Ps,_,_), Strokes), S > 0,
                 member(P, Ps) ),
            Points0),
    sort(Points0, Points).

extent(Points, X1, Y1, X2, Y2) :-
    findall(X, member(X-_, Points), Xs),
    findall(Y, member(_-Y, Points), Ys),
    min_list(Xs, X1),
    max_list(Xs, X2),
    min_list(Ys, Y1),
    max_list(Ys, Y2).

view_extent(Drawing, Name, X1, Y1, X2, Y2) :-
    model_points(Drawing, Name, Points),
    extent(Points, X1, Y1, X2, Y2).

xs(Points, Xs) :-
    findall(X, member(X-_, Points), Xs0),
    sort(Xs0, Xs).
ys(Points, Ys) :-
    findall(Y, member(_-Y, Points), Ys0),
    sort(Ys0, Ys).

texts(drawing(_,Views), Texts) :-
    findall(T, ( member(view(_,_,Own), Views), member(text(_,_,_,_,T), Own) ),
            Texts).

sheet_error(Options, What) :-
    catch(( drawn_sheet(two_cubes, Options, _), What = none ),
          error(usage_error(What), _), true).

facts_file(Facts, File) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    write(Out, Facts),
    close(Out).

:- begin_tests(sheet_plan).

test(true_scale, true(W-H == 20 000-20 000)) :-
    drawn_sheet(cube, [sheet(a4),views(front),scale('20:1')], Drawing),
    view_extent(Drawing, front, X1, Y1, X2, Y2),
    W is X2-X1,
    H is Y2-Y1.
test(unit, true(W == 500 000)) :-
    drawn_sheet(cube, [sheet(a0),views(front),scale('1:2'),unit(m)], Drawing),
    view_extent(Drawing, front, X1, _, X2, _),
    W is X2-X1.
test(size, true(Sheet == sheet(594 000,420 000,5.0))) :-
    drawn_sheet(cube, [sheet(a2),scale('5:1')], drawing(Sheet,_)).
test(usual_views, true(Names == [front,top,right,isometric,frame])) :-
    drawn_sheet(cube, [sheet(a3)], drawing(_,Views)),
    findall(Name, member(view(Name,_,_), Views), Names).
test(standard_scale) :-                 % the next one does not fit
    drawn_sheet(pipe_tee, [sheet(a3)], Drawing),
    texts(Drawing, Texts),
    memberchk("20:1", Texts),
    catch(( drawn_sheet(pipe_tee, [sheet(a3),scale('50:1')], _),
            fail ),
          error(usage_error(sheet(too_large(50:1,'A3',20:1,_))), _),
          true).
test(fit_is_larger, true) :-
    drawn_sheet(pipe_tee, [sheet(a3)], drawing(sheet(_,_,Standard),_)),
    drawn_sheet(pipe_tee, [sheet(a3),scale(fit)], drawing(sheet(_,_,Fit),_)),
    Fit >= Standard,
    Fit < Standard*2.5.

test(fit_whatever_the_size, [forall(member(E, [9,12,80]))]) :-
    format(atom(Facts), 'segment(1, solid, box(size(~we~w,~we~w,~we~w))).~n',
           [2.0,E,2.0,E,2.0,E]),
    facts_file(Facts, File),
    sheet_of(File, [sheet(a4),scale(fit)], Drawing),
    view_extent(Drawing, front, X1, _, X2, _),
    X2-X1 > 30 000,
    X2-X1 < 160 000.
test(too_large_for_standard,
     error(usage_error(sheet(no_room('A4'))))) :-
    facts_file('segment(1, solid, box(size(2.0e12,1.0,1.0))).', File),
    sheet_of(File, [sheet(a4)], _).

test(a_letter_for_each_section,
     error(usage_error(sheet(many_sections(24))))) :-
    findall(Text, ( between(1, 25, I), format(atom(Text), 'x=0.~d', [I]) ),
            Texts),
    drawn_sheet(cube, [sheet(a0),section(Texts)], _).

% The same X in the views above one another, the same Y beside one another: of
% the very same vertices, so to the last digit.
test(aligned, [forall(member(Angle, [first,third]))]) :-
    drawn_sheet('figures/fig12',
                [sheet(a2),views('front,top,bottom,left,right,back'),
                 angle(Angle),lines(all)], Drawing),
    forall(member(Name, [top,bottom]),
           ( view_extent(Drawing, front, X1, _, X2, _),
             view_extent(Drawing, Name, X1, _, X2, _) )),
    forall(member(Name, [left,right,back]),
           ( view_extent(Drawing, front, _, Y1, _, Y2),
             view_extent(Drawing, Name, _, Y1, _, Y2) )).
test(all_points_aligned) :-             % each corner of a turned block
    drawn_sheet(hollow_block, [sheet(a3),views('front,top,right')], Drawing),
    model_points(Drawing, front, Front),
    model_points(Drawing, top, Top),
    model_points(Drawing, right, Right),
    xs(Front, Xs),
    xs(Top, Xs),
    ys(Front, Ys),
    ys(Right, Ys).
test(places, [forall(member(Angle-Name-Where,
                     [ first-top-below, third-top-above, first-right-left,
                       third-right-right, first-left-right, third-left-left,
                       first-bottom-above, third-bottom-below,
                       first-back-right, third-back-right ]))]) :-
    drawn_sheet(two_cubes, [sheet(a2),angle(Angle),
                            views('front,top,right,left,bottom,back')],
                Drawing),
    view_extent(Drawing, front, X1, Y1, X2, Y2),
    view_extent(Drawing, Name, A1, B1, A2, B2),
    memberchk(Where-Apart, [ above-(Y1-B2), below-(B1-Y2), left-(X1-A2),
                             right-(A1-X2) ]),
    Apart > 8000.
test(in_the_frame, [forall(sampled([Model,Paper],
                                   ( member(Model, [ two_cubes,pipe_tee,
                                                     hollow_block ]),
                                     member(Paper, [a4,a3,a1]) )))]) :-
    drawn_sheet(Model, [sheet(Paper),section([x,y,'1,1,0,-0.1'])], Drawing),
    Drawing = drawing(sheet(W,H,_), Views),
    forall(( member(view(Name,Strokes,Texts), Views), Name \== frame ),
           ( forall(( member(stroke(_,_,_,_,Points,_,_), Strokes),
                      member(X-Y, Points) ),
                    in_frame(W, H, X, Y)),
             forall(member(text(X,Y,High,_,_), Texts),
                    ( Above is Y-High, in_frame(W, H, X, Above),
                      in_frame(W, H, X, Y) )) )).

in_frame(W, H, X, Y) :-
    X > 20 000,
    Y > 10 000,
    X < W-10 000,
    Y < H-10 000,
    \+ ( X > W-190 000, Y > H-46 000 ).

test(no_overlap, [forall(member(Model, [two_cubes,pipe_tee]))]) :-
    drawn_sheet(Model, [sheet(a3),section([x,z]),
                        views('front,top,right,left,isometric')],
                Drawing),
    Drawing = drawing(_, Views),
    findall(r(X1,Y1,X2,Y2),
            ( member(view(Name,Strokes,_), Views),
              \+ memberchk(Name, [frame,centre_lines]),
              findall(P, ( member(stroke(_,_,_,_,Ps,_,_), Strokes),
                           member(P, Ps) ), All),
              extent(All, X1, Y1, X2, Y2) ),
            Rs),
    length(Rs, 7),
    \+ ( select(r(A1,B1,A2,B2), Rs, Others), member(r(C1,D1,C2,D2), Others),
         A1 < C2, C1 < A2, B1 < D2, D1 < B2 ).
% Many parallel sections stand in rows, clear of each other.
test(many_sections, [forall(member(Angle, [first,third]))]) :-
    findall(Text, ( between(1, 14, I), At is I/15.0,
                    format(atom(Text), 'x=~4f', [At]) ),
            Texts),
    drawn_sheet(cube, [sheet(a2),angle(Angle),section(Texts)], Drawing),
    findall(Name-r(X1,Y1,X2,Y2),
            ( member(Name, ['A','B','C','D','E','F','G','H','J','K','L','M',
                            'N','P',front,top,right,isometric]),
              view_extent(Drawing, Name, X1, Y1, X2, Y2) ),
            Named),
    length(Named, 18),
    \+ ( select(N-r(A1,B1,A2,B2), Named, Others),
         member(M-r(C1,D1,C2,D2), Others),
         A1 < C2, C1 < A2, B1 < D2, D1 < B2,
         N \== M ).

% A plane askew would go through the letter at the end of another.
test(letters_spared, [forall(member(Model, [ 'cylinder(radius(10),height(50))',
                                             'box(size(18,20,50))' ]))]) :-
    format(atom(Text), 'segment(1, solid, ~w).', [Model]),
    facts_file(Text, File),
    sheet_of(File, [sheet(a4),section([x,y,'1,1,0,0','x=4'])], Drawing),
    Drawing = drawing(_, Views),
    forall(( member(view(_,Strokes,Texts), Views),
             member(text(X,Y,High,_,_), Texts),
             member(stroke(_,cutting,_,_,Points,_,_), Strokes) ),
           \+ passes(Points, X, Y, High)),
    once(( member(view(_,Strokes,_), Views),
           member(stroke(_,cutting,_,_,_,_,_), Strokes) )).

% Nor is a letter on what the view shows, where the plane goes through a corner.
test(letters_beside, [forall(member(Plane, ['1,0,1,-3', '1,0,1,30',
                                             '2,0,-1,0' ]))]) :-
    drawn_sheet(bracket, [sheet(a1),views('front,back'),section([Plane])],
                Drawing),
    Drawing = drawing(_, Views),
    findall(A, ( member(view(Name,_,Texts), Views),
                 memberchk(Name, [front,back]),
                 member(text(X,Y,High,_,_), Texts),
                 view_extent(Drawing, Name, X1, Y1, X2, Y2),
                 A = at(X,Y,High,X1,Y1,X2,Y2) ),
            Letters),
    Letters = [_,_],
    \+ ( member(at(X,Y,High,X1,Y1,X2,Y2), Letters),
         X > X1, X < X2, Y > Y1, Y-High < Y2 ).

% passes(Points, X, Y, High): one of 50 points along Points is in the letter.
passes([X1-Y1,X2-Y2], X, Y, High) :-
    between(0, 50, I),
    abs(X1 + I*(X2-X1)/50 - X) < 0.3*High,
    At is Y1 + I*(Y2-Y1)/50,
    At > Y-High,
    At < Y.

% At the largest standard scale it could not be seen.
test(tiny, true(Wide > 20 000)) :-
    facts_file('segment(1, solid, box(size(1.0e-80,2.0e-80,3.0e-80))).', File),
    warnings(sheet_of(File, [sheet(a4)], Drawing), Warned),
    Warned = [sheet_tiny(1 000 000 000:1,fit)],
    view_extent(Drawing, front, X1, _, X2, _),
    Wide is X2-X1.
test(tiny_as_asked, Warned == [sheet_tiny(1:1000,as_asked)]) :-
    warnings(drawn_sheet(cube, [sheet(a4),scale('1:1000'),views(front)], _),
             Warned0),
    Warned = Warned0.

:- dynamic warned/1.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(What), warning, _) :-
    What = sheet_tiny(_,_),
    assertz(test_sheet_plan:warned(What)).

:- meta_predicate warnings(0, -).

warnings(Goal, Warned) :-
    retractall(test_sheet_plan:warned(_)),
    call(Goal),
    findall(What, test_sheet_plan:warned(What), Warned).

test(hidden_usual) :-                   % dashed from the sides alone
    drawn_sheet(pipe_tee, [sheet(a3),section([y])], Drawing),
    forall(member(Name, [front,top,right]),
           ( drawing_view(Drawing, Name, Strokes, _),
             once(member(stroke(hidden,_,_,_,_,_,_), Strokes)) )),
    forall(member(Name, [isometric,'A']),
           ( drawing_view(Drawing, Name, Strokes, _),
             \+ memberchk(stroke(hidden,_,_,_,_,_,_), Strokes) )).
test(hidden_dashed) :-
    drawn_sheet(pipe_tee, [sheet(a3),hidden(dashed)], Drawing),
    drawing_view(Drawing, isometric, Strokes, _),
    once(member(stroke(hidden,_,_,_,_,_,_), Strokes)).
test(world_stays) :-
    absolute_file_name(sanggwan('facts/two_cubes.pl'), File),
    sheet_request([sheet(a3),section([x])], [], Request0),
    new_world(World),
    in_world(World,
             ( load_model(File),
               request_facts([], [File], Request0, Request),
               rows(Before),
               views_drawing(Request, [], sheet_of:cuts(cut, cut), _, _),
               rows(After) )),
    Before == After.

rows(Rows) :-
    findall(v(S,V,X,Y,Z), v(S,V,X,Y,Z), Rows1),
    findall(e(S,E,A,B,T), e(S,E,A,B,T), Rows2),
    findall(p(S,P,Es), p(S,P,Es), Rows3),
    findall(segment(S,K,N), segment(S,K,N), Rows4),
    findall(view(A,B,C), view(A,B,C), Rows5),
    findall(drawn(A), drawn(A,_,_,_,_,_,_), Rows6),
    append([Rows1,Rows2,Rows3,Rows4,Rows5,Rows6], Rows).

test(section_hatched, true) :-          % length times spacing is the area
    drawn_sheet(cube, [sheet(a3),scale('50:1'),section([x])], Drawing),
    drawing_view(Drawing, 'A', Strokes, _),
    findall(L, ( member(stroke(visible,hatching,1,[],[X1-Y1,X2-Y2],_,_),
                        Strokes),
                 L is sqrt((X2-X1)**2+(Y2-Y1)**2) ),
            Ls),
    sum_list(Ls, Sum),
    Spacing is Sum*4000/50 000**2,
    abs(Spacing-1) < 0.02.
test(section_letters) :-
    drawn_sheet(two_cubes, [sheet(a3),section([x,z])], Drawing),
    texts(Drawing, Texts),
    forall(member(T-N, ["A-A"-1,"B-B"-1,"A"-4,"B"-4]),
           ( findall(x, member(T, Texts), All),   % two of the grid
             length(All, N) )).
test(section_sides_alternate) :-
    drawn_sheet(two_cubes, [sheet(a3),section([x])], Drawing),
    drawing_view(Drawing, 'A', Strokes, _),
    forall(member(S-Sign, [1-(-1),2-1]),
           forall(member(stroke(_,hatching,S,_,[X1-Y1,X2-Y2],_,_), Strokes),
                  ( X1 =:= X2 -> true
                  ; Sign =:= sign((X2-X1)*(Y2-Y1)) ))).
test(section_role) :-
    drawn_sheet(cube, [sheet(a3),section([x])], Drawing),
    drawing_view(Drawing, 'A', Strokes, _),
    findall(S-N, ( member(stroke(visible,section,S,Es,_,_,_), Strokes),
                   length(Es, N) ),
            [1-4]).
test(section_of_surfaces) :-            % lines, nothing hatched
    drawn_sheet('figures/fig09', [sheet(a3),section([x])], Drawing),
    drawing_view(Drawing, 'A', Strokes, _),
    once(memberchk(stroke(_,section,_,_,_,_,_), Strokes)),
    \+ memberchk(stroke(_,hatching,_,_,_,_,_), Strokes).
test(no_plane_seen, true(Lines == [])) :-  % the front cannot show y=...
    drawn_sheet(cube, [sheet(a3),views(front),section([y])], Drawing),
    drawing_view(Drawing, front, Strokes, _),
    findall(R, ( member(stroke(_,R,_,_,_,_,_), Strokes),
                 memberchk(R, [cutting,cutting_end,arrow]) ),
            Lines).
test(arrow_shows_where_one_looks) :-    % from the right: to the left
    drawn_sheet(cube, [sheet(a3),section([x])], Drawing),
    drawing_view(Drawing, front, Strokes, _),
    findall(X1-X2, member(stroke(_,arrow,_,_,[X1-Y,X2-Y],_,_), Strokes),
            [A1-A2,B1-B2]),
    A1 > A2,
    B1 > B2.
test(no_frame, true(Names == [front])) :-
    drawn_sheet(cube, [sheet(a3),views(front),'no-frame'(true)],
                drawing(_,Views)),
    findall(Name, member(view(Name,_,_), Views), Names).

test(title_block) :-
    absolute_file_name(sanggwan('facts/cube.pl'), File),
    tmp_file_stream(Title, Out, [encoding(utf8),extension(pl)]),
    format(Out, 'title_block(name, "받침대").~ntitle_block(number, 17).~n\c
                 title_block(date, ''2026-11-21'').~n', []),
    close(Out),
    sheet_of(File, [sheet(a3),'title-block'(Title),language(ko)], Drawing),
    delete_file(Title),
    texts(Drawing, Texts),
    forall(member(T, ["받침대","17","2026-11-21","척도","도명","100:1","A3"]),
           memberchk(T, Texts)),
    \+ memberchk("cube", Texts).
test(name_of_file) :-
    drawn_sheet(cube, [sheet(a3)], Drawing),
    texts(Drawing, Texts),
    memberchk("cube", Texts),
    memberchk("Name", Texts).
test(model_title) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    format(Out, 'segment(1, solid, box(size(1,2,3))).~n\c
                 title_block(name, "Bracket").~n', []),
    close(Out),
    sheet_of(File, [sheet(a3)], Drawing),
    delete_file(File),
    texts(Drawing, Texts),
    memberchk("Bracket", Texts).
test(last_model_counts, true(Items == [material-'SS400',name-'B'])) :-
    facts_file("segment(1, solid, box(size(1,2,3))).\n\c
                title_block(name, a). title_block(material, 'SS400').\n", A),
    facts_file("segment(1, solid, box(size(1,1,1))).\n\c
                title_block(name, \"B\").\n", B),
    new_world(World),
    in_world(World, ( load_model(A),
                      load_model(B),
                      findall(I-T, title_block(I, T), Items0) )),
    sort(Items0, Items),
    maplist(delete_file, [A,B]).
test(twice, error(model_error(twice(title_block,_)), _)) :-
    facts_file("segment(1, solid, box(size(1,2,3))).\n\c
                title_block(name, a). title_block(name, b).\n", File),
    new_world(World),
    setup_call_cleanup(true, in_world(World, load_model(File)),
                       delete_file(File)).
test(no_text, [forall(member(Text, ["f(x)", "_", "[]", "[a]"])),
               error(model_error(value(title_block,'Text',_,text)), _)]) :-
    format(string(Facts), "segment(1, solid, box(size(1,2,3))).\n\c
                           title_block(name, ~s).\n", [Text]),
    facts_file(Facts, File),
    new_world(World),
    setup_call_cleanup(true, in_world(World, load_model(File)),
                       delete_file(File)).
test(fitting_text) :-                   % a long name becomes small
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    numlist(1, 60, Ns),
    maplist([_,0'W]>>true, Ns, Codes),
    format(Out, 'segment(1, solid, box(size(1,2,3))).~n\c
                 title_block(name, "~s").~n', [Codes]),
    close(Out),
    sheet_of(File, [sheet(a3)], Drawing),
    delete_file(File),
    drawing_view(Drawing, frame, _, Texts),
    string_codes(Name, Codes),
    memberchk(text(_,_,High,middle,Name), Texts),
    High*60*0.9 =< 97 100.
test(text_that_does_not_fit, High-Start == 1000-"WWW") :-
    length(Codes, 5000),
    maplist(=(0'W), Codes),
    format(atom(Facts), 'segment(1, solid, box(size(1,2,3))).~n\c
                         title_block(name, "~s").~n', [Codes]),
    facts_file(Facts, File),
    sheet_of(File, [sheet(a3)], Drawing),
    drawing_view(Drawing, frame, _, Texts),
    member(text(_,_,High,middle,Text), Texts),
    string_concat(Kept, "...", Text),
    !,
    string_length(Kept, N),
    N*0.9 =< 97,
    sub_string(Kept, 0, 3, _, Start).
test(text_on_one_line) :-
    facts_file('segment(1, solid, box(size(1,2,3))).\n\c
                title_block(name, "a\\nb\\tc").', File),
    sheet_of(File, [sheet(a3)], Drawing),
    drawing_view(Drawing, frame, _, Texts),
    memberchk(text(_,_,_,middle,"a b c"), Texts).

test(svg_ids_once) :-
    drawn_sheet(two_cubes, [sheet(a3),section([x])], Drawing),
    with_output_to(string(Svg),
                   ( current_output(Out),
                     write_drawing_stream(svg, Out, [drawing(Drawing)]) )),
    split_string(Svg, "\n", "", Lines),
    findall(Id, ( member(Line, Lines),
                  sub_string(Line, B, _, _, " id=\""),
                  From is B+5,
                  sub_string(Line, From, _, 0, Rest),
                  split_string(Rest, "\"", "", [Id|_]) ),
            Ids),
    sort(Ids, Once),
    length(Ids, N),
    length(Once, N),
    N > 20.
test(same_bytes, true(A == B)) :-
    drawn_sheet(pipe_tee, [sheet(a3),section([y])], A),
    drawn_sheet(pipe_tee, [sheet(a3),section([y])], B).

test(draw) :-                           % the predicate, nodes as roots
    absolute_file_name(sanggwan('facts/pipe_tee.pl'), Model),
    tmp_file_stream(File, Out, [extension(svg)]),
    close(Out),
    new_world(World),
    in_world(World,
             ( load_model(Model),
               draw(File, [sheet(a3),section([y]),language(ko)]),
               findall(S, segment(S, _, _), Ss),
               \+ drawn(_,_,_,_,_,_,_) )),
    Ss = [_,_,_|_],
    read_file_to_string(File, Text, [encoding(utf8)]),
    delete_file(File),
    once(sub_string(Text, _, _, _, "척도")),
    once(sub_string(Text, _, _, _, "hatching")).

test(faults, [forall(member(Options-What,
         [ [sheet('B7')]-sheet(paper('B7',_)),
           [sheet(a3),views('front,tpo')]-sheet(view("tpo",_)),
           [views('front,front')]-sheet(view_twice(front)),
           [views('iso,isometric')]-sheet(view_twice(iso)),
           [sheet(a3),scale('2')]-sheet(scale('2')),
           [sheet(a3),scale('0:2')]-sheet(scale('0:2')),
           [sheet(a3),scale('1:1e-320')]-sheet(scale('1:1e-320')),
           [sheet(a3),scale('1:1e200')]-sheet(scale('1:1e200')),
           [sheet(a3),scale('1e200:1')]-sheet(scale('1e200:1')),
           [sheet(a4),scale('50:1')]-sheet(too_large(50:1,'A4',20:1,['A2'])),
           [sheet(a4),scale('9000:1')]-sheet(too_large(9000:1,'A4',20:1,[])),
           [section(['x=77'])]-sheet(section_past('x=77',box(_,_,_,_,_,_))),
           [section([w])]-sheet(section(w)),
           [section(['0,0,0,1'])]-sheet(section('0,0,0,1')),
           [sheet(a3),direction('0,0,0')]-sheet(no_direction(_,'0,0,0')),
           [sheet(a3),eye('1,2,3'),target('1,2,3')]
             -sheet(no_direction('--eye','1,2,3')),
           [sheet(a3),direction('0,0')]-bad_value('--direction','0,0',_),
           [sheet(a3),target('1,2,3')]-needs_one_of(['--eye']),
           [sheet(a3),view(front),eye('1,2,3')]-both_options(_,_),
           [views(front),view(top)]-both_options('--views','--view'),
           [sheet(a3),size('100x100')]-both_options('--size','--sheet'),
           [sheet(a3),projection(central)]-both_options(_,_)
         ]))]) :-
    sheet_error(Options, Found),
    subsumes_term(What, Found).

test(words_in_both) :-
    forall(sheet_word(Item, en, _), sheet_word(Item, ko, _)),
    forall(sheet_word(Item, ko, _), sheet_word(Item, en, _)).
test(message, true(Text == "at 5:1 the views do not fit on A4\n\c
                            \x20 --scale 1:2 does fit, or take --sheet A1.")) :-
    phrase(sheet_en(too_large(5:1, 'A4', 1:2, ['A1'])), Lines),
    with_output_to(string(Text0),
                   print_message_lines(current_output, '', Lines)),
    string_concat(Text, "\n", Text0).

:- end_tests(sheet_plan).
