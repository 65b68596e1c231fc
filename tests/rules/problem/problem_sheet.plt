:- encoding(utf8).
/* Problem sheets: nothing of the answer is in the question, and the key is what
   closed forms say.
   covers: problem_drawing, problem_file, problem_item, problem_key
   covers: problem_loop, problem_pattern, problem_point, problem_sheet
   covers: problem_text, sheet_construction, about */
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(about)).
:- use_module(rules(message/problem_en)).
:- use_module(rules(message/spoken)).
:- use_module(rules(message/problem_ko)).
:- use_module(rules(problem/problem_file)).
:- use_module(rules(problem/problem_sheet)).
:- use_module(rules(sheet/lettering)).

:- begin_tests(problem_sheet).

model(Name, File) :-
    format(atom(Local), 'facts/problems/~w.pl', [Name]),
    absolute_file_name(sanggwan(Local), File).

%   with_sheets(Name, Items, Variants, Options, Folder, Goal): with the sheets
%   of one problem in Folder.

:- meta_predicate with_sheets(+, +, +, +, -, 0).

with_sheets(Name, Items, Variants, Options, Folder, Goal) :-
    with_sheets_on('A3', Name, Items, Variants, Options, Folder, Goal).

:- meta_predicate with_sheets_on(+, +, +, +, +, -, 0).

with_sheets_on(Paper, Name, Items, Variants, Options, Folder, Goal) :-
    problem_facts(Paper, Name, Items, Variants, [angle(third)], Facts),
    tmp_file(problems, Folder),
    make_directory_path(Folder),
    setup_call_cleanup(
        facts_written(Folder, Facts, File),
        ( problem_sheets(File, Folder, Options),
          call(Goal) ),
        delete_directory_and_contents(Folder)).

problem_facts(Paper, Name, Items, Variants, SheetItems, Facts) :-
    model(Name, Model),
    findall(variant(Name, Parameter, Values),
            member(Parameter-Values, Variants),
            Rows),
    append([problem(Name, Model, Items)|Rows],
           [sheet(Paper, [Name], SheetItems)], Facts).

facts_written(Folder, Facts, File) :-
    directory_file_path(Folder, 'one.pl', File),
    setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                       forall(member(Fact, Facts),
                              format(Out, '~k.~n', [Fact])),
                       close(Out)).

%   with_facts(Facts, Paper, Name, Items, Variants, SheetItems, Folder, Fault):
%   the sheets of these, in Folder, which stays if there is no Fault (`none`).

with_facts(More, Paper, Name, Items, Variants, SheetItems, Folder, Fault) :-
    problem_facts(Paper, Name, Items, Variants, SheetItems, Facts0),
    append(Facts0, More, Facts),
    tmp_file(problems, Folder),
    make_directory_path(Folder),
    facts_written(Folder, Facts, File),
    catch(( problem_sheets(File, Folder, []), Fault = none ),
          error(Fault, _),
          delete_directory_and_contents(Folder)).

text(Folder, Local, Text) :-
    directory_file_path(Folder, Local, File),
    read_file_to_string(File, Text, [encoding(utf8)]).

key(Folder, Number, Key) :-
    format(atom(Local), '~w-key.json', [Number]),
    directory_file_path(Folder, Local, File),
    setup_call_cleanup(open(File, read, In, [encoding(utf8)]),
                       json_read_dict(In, Key),
                       close(In)).

%   places(Text, Class, Places): the points of the polylines of a class.

places(Text, Class, Places) :-
    split_string(Text, "\n", "", Lines),
    findall(Place,
            ( member(Line, Lines),
              sub_string(Line, _, _, _, Class),
              sub_string(Line, Before, _, _, "points=\""),
              Start is Before+8,
              sub_string(Line, Start, _, 0, Rest),
              split_string(Rest, "\"", "", [Points|_]),
              split_string(Points, " ", "", All),
              member(Place, All) ),
            Places0),
    sort(Places0, Places).

leaks(fig10, [a-[40]], [front,top,right]).
leaks(fig11, [r-[25]], [front,top,right]).
leaks(fig12, [r-[14]], [front,top,right]).
leaks(fig13, [r-[26]], [front,top,right]).
leaks(fig14, [e-[16]], [front,top,right]).

%   No point of the line, no word of it and no construction is in the question.
%   (Points of the line of dev15 are corners of what is given: it is not here.)
test(nothing_leaks, [forall(leaks(Name, Variants, Views)), Found == []]) :-
    with_sheets(Name, [given(Views),ask(draw(penetration))],
                Variants, [], Folder,
                ( atomic_list_concat([Name,'-1-question.svg'], Question),
                  atomic_list_concat([Name,'-1-answer.svg'], Answer),
                  text(Folder, Question, Asked),
                  text(Folder, Answer, Answered) )),
    places(Answered, "penetration", Places),
    length(Places, Count),
    Count > 8,
    findall(Word,
            ( ( member(Word, ["visible penetration","hidden penetration",
                              "construction"])
              ; member(Word, Places)
              ),
              sub_string(Asked, _, _, _, Word) ),
            Found).

%   The views in which the line is to be drawn have it in the answer, the others
%   do not; the question has it in none, and says where.
test(drawn_in_some_views,
     [true(Found == [ front-(false-true), top-(false-true),
                      right-(false-false) ])]) :-
    with_sheets(fig12,
                [ given([front,top,right]), hide(penetration),
                  ask(draw(penetration, [front,top])) ],
                [r-[14]], [], Folder,
                ( text(Folder, 'fig12-1-question.svg', Asked),
                  text(Folder, 'fig12-1-answer.svg', Answered) )),
    findall(View-(InQuestion-InAnswer),
            ( member(View, [front,top,right]),
              line_seen(Asked, View, InQuestion),
              line_seen(Answered, View, InAnswer) ),
            Found),
    has(Asked, "in the front view and", true).

test(drawn_in_some_views_ko, true(Has == true)) :-
    with_sheets(fig12, [ given([front,top]), ask(draw(penetration, [top])) ],
                [r-[14]], [language(ko)], Folder,
                text(Folder, 'fig12-1-question.svg', Asked)),
    has(Asked, "평면도에 원뿔과 원기둥의 상관선을", Has).

%   It is said beside one's own text, too.
test(drawn_in_some_views_own_text,
     [forall(member(Language-Where, [en-"Where? (In the top view.)",
                                     ko-"어디인가? (평면도에 그린다.)"])),
      true(Has == true)]) :-
    with_sheets(fig12, [ given([front,top]), ask(draw(penetration, [top])),
                         text(en, 'Where?'), text(ko, '어디인가?') ],
                [r-[14]], [language(Language)], Folder,
                text(Folder, 'fig12-1-question.svg', Asked)),
    has(Asked, Where, Has).

line_seen(Text, View, Seen) :-
    view_text(Text, View, Own),
    has(Own, "penetration", Seen).

%   show(penetration): the line is given, and what follows from it is asked.
test(line_given, [true(Found == [true,true])]) :-
    with_sheets(fig12,
                [ given([front,top]), show(penetration), ask(develop(2)) ],
                [r-[14]], [], Folder,
                text(Folder, 'fig12-1-question.svg', Asked)),
    findall(Seen, ( member(View, [front,top]), line_seen(Asked, View, Seen) ),
            Found).

%   A blank view has no line of what is to be drawn there; what is asked for is
%   written in the answer and in the key alone, and of a point that is asked for
%   one view tells where it is.
test(blank_view_is_blank, [true(Found == [])]) :-
    with_sheets(fig12, [given([front,top]),blank(right),ask(draw(penetration))],
                [r-[14]], [], Folder,
                ( text(Folder, 'fig12-1-question.svg', Asked),
                  text(Folder, 'fig12-1-answer.svg', Answered) )),
    view_text(Answered, right, Right),
    places(Right, "", Places),
    length(Places, Count),
    Count > 20,
    findall(Place,
            ( member(Place, Places), sub_string(Asked, _, _, _, Place) ),
            Found),
    view_text(Asked, right, Blank),
    places(Blank, "", Corners),
    length(Corners, 4).

%   Auxiliary planes are in the answer alone.
test(planes_in_answer, [forall(member(Planes, [planes(z),planes(straight),
                                               planes(z,5)])),
                        true(Asked-More == false-true)]) :-
    Items = [given([front,top,right]), ask(draw(penetration))],
    with_sheets(fig12, [Planes|Items], [r-[14]], [], Folder,
                ( text(Folder, 'fig12-1-question.svg', Text1),
                  text(Folder, 'fig12-1-answer.svg', Text2),
                  key(Folder, 'fig12-1', Key) )),
    has(Text1, "construction", Asked),
    has(Text2, "construction", More),
    length(Key.planes, Count),
    ( Planes = planes(_,N) -> Count =:= N
    ; Planes == planes(z) -> Count =:= 7
    ; Count =:= 0
    ).

asked_value(fig12, shortest_generator(2), mm, 0.01, r-[14]).
asked_value(fig12, area(1), mm2, 1, r-[14]).
asked_value(fig12, coordinate(3, x), mm, 0.01, r-[14]).
asked_value(fig14, generator(2, 3), mm, 0.01, e-[10]).
asked_value(fig10, edge(1, 1, 5), mm, 0.01, a-[40]).

test(no_value_leaks, [forall(asked_value(Name, Measure, Unit, Tolerance, By)),
                      true(Asked-Answered == false-true)]) :-
    with_sheets(Name,
                [ given([front,top,right]), ask(draw(penetration)),
                  ask(measure(Measure, Unit, Tolerance)) ],
                [By], [], Folder,
                ( atomic_list_concat([Name,'-1-question.svg'], Question),
                  atomic_list_concat([Name,'-1-answer.svg'], Answer),
                  atom_concat(Name, '-1', Number),
                  text(Folder, Question, Text1),
                  text(Folder, Answer, Text2),
                  key(Folder, Number, Key) )),
    Key.measures = [One],
    (   Tolerance < 1
    ->  format(string(Shown), '~2f ', [One.value])
    ;   format(string(Shown), '~0f ', [One.value])
    ),
    has(Text1, Shown, Asked),
    has(Text2, Shown, Answered).

has(Text, Word, Has) :-
    (   sub_string(Text, _, _, _, Word)
    ->  Has = true
    ;   Has = false
    ).

%   The letter of a point that is asked for stands in one view of the question.
test(one_view_tells, [true(Count1-Count2 == 1-3)]) :-
    with_sheets(fig12,
                [ given([front,top,right]), ask(draw(penetration)),
                  ask(measure(coordinate(3, x), mm, 0.1)) ],
                [r-[14]], [], Folder,
                ( text(Folder, 'fig12-1-question.svg', Text1),
                  text(Folder, 'fig12-1-answer.svg', Text2) )),
    lettered(Text1, Count1),
    lettered(Text2, Count2).

%   lettered(Text, Count): how often an A stands beside a point; the grid of the
%   sheet has two more.

lettered(Text, Count) :-
    split_string(Text, "\n", "", Lines),
    aggregate_all(count,
                  ( member(Line, Lines),
                    ( sub_string(Line, _, _, 0, ">A</text>")
                    ; sub_string(Line, _, _, 0, ",A</text>")
                    ; sub_string(Line, _, _, _, ">A,")
                    ) ),
                  All),
    Count is All-2.

view_text(Text, View, Own) :-
    format(string(Group), "<g id=\"~w\" class=\"view\">", [View]),
    sub_string(Text, Start, _, _, Group),
    Begin is Start+20,
    sub_string(Text, Begin, _, 0, Rest),
    (   sub_string(Rest, End, _, _, "class=\"view\"")
    ->  true
    ;   string_length(Rest, End)
    ),
    sub_string(Rest, 0, End, _, Own),
    !.

%   The points are on both true surfaces, however they are divided.
test(points_of_two_cylinders, Count =:= 24) :-
    with_sheets(fig14, [given([front,top]),ask(count(loops))], [e-[10]], [],
                Folder, key(Folder, 'fig14-1', Key)),
    Key.loops =:= 2,
    Key.parameters.e =:= 10,
    Points = Key.points,
    length(Points, Count),
    forall(member(Point, Points),
           ( abs(Point.x**2 + Point.y**2 - 36**2) < 1.0e-3,
             abs((Point.y+10)**2 + Point.z**2 - 24**2) < 1.0e-3 )),
    findall(N, ( member(Point, Points), N = Point.number ), Numbers),
    numlist(1, 24, Numbers).

test(points_of_cone, Count =:= 24) :-
    with_sheets(fig12, [given([front,top])], [r-[18]], [],
                Folder, key(Folder, 'fig12-1', Key)),
    Points = Key.points,
    length(Points, Count),
    forall(member(Point, Points),
           ( R is 45*(1 - Point.z/110),
             abs(Point.x**2 + Point.y**2 - R*R) < 1.0e-3,
             abs(Point.y**2 + (Point.z-32)**2 - 18**2) < 1.0e-3 )).

%   Two equal cylinders meet in two ellipses that cross in two points, which
%   count once; each lies in one plane.
test(points_once, Count =:= 22) :-
    with_sheets(fig13, [given([front]),ask(count(loops))], [r-[30]], [], Folder,
                key(Folder, 'fig13-1', Key)),
    Key.loops =:= 2,
    Key.open_lines =:= 0,
    Points = Key.points,
    length(Points, Count),
    forall(member(Loop-Sign, [1-1,2-(-1)]),
           ( member(First, Points), First.loop =:= Loop, abs(First.x) > 1,
             Turn is Sign*sign(First.x*First.z),
             ( Loop =:= 1 ; Turn =\= 0 ),
             !,
             forall(( member(Point, Points), Point.loop =:= Loop ),
                    abs(abs(Point.x) - abs(Point.z)) < 1.0e-5) )).

%   A straight line goes through the cone itself, not through its facets.
test(pierced, Count =:= 2) :-
    with_sheets(fig08, [given([front,top]),branch(2)], [h-[80]], [], Folder,
                key(Folder, 'fig08-1', Key)),
    Points = Key.points,
    length(Points, Count),
    forall(member(Point, Points),
           ( R is 40*(1 - Point.z/80),
             abs(sqrt(Point.x**2 + Point.y**2) - R) < 1.0e-5,
             T is (Point.x+56)/112,
             abs(Point.y - (-20+32*T)) < 1.0e-5,
             abs(Point.z - (14+24*T)) < 1.0e-5 )).

%   The corners of the lines of two pyramids lie on edges.
test(corners, Count =:= 8) :-
    with_sheets(fig10, [given([front])], [a-[40]], [], Folder,
                key(Folder, 'fig10-1', Key)),
    Key.loops =:= 2,
    length(Key.points, Count).

test(developments) :-
    with_sheets(dev15, [given([front]),ask(develop(2))], [r-[25]], [], Folder,
                ( key(Folder, 'dev15-1', Key),
                  text(Folder, 'dev15-1-development-2.svg', Text) )),
    Key.developments = [Pattern],
    Pattern.parts = [Part],
    Area is 2*pi*25*75 - 4*25*25,       % to the axis less a half of the cross
    abs(Part.area - Area) < 1.0e-3*Area,
    Generators = Part.generators,
    length(Generators, 13),
    forall(( member(Generator, Generators), T = Generator.degrees ),
           ( Length is 75 - 25*abs(cos(T*pi/180)),
             Other is 75 - 25*abs(sin(T*pi/180)),
             ( abs(Generator.length-Length) < 1.0e-5
             ; abs(Generator.length-Other) < 1.0e-5
             ) )),
    sub_string(Text, _, _, _, "cut"),
    !.

test(box, Area =:= 8800.0) :-
    with_sheets(dev09, [given([front,top]),ask(develop(1))], [h-[20]], [],
                Folder, key(Folder, 'dev09-1', Key)),
    Key.developments = [Pattern],
    Pattern.parts = [Part],
    Area = Part.area.

test(variants, Lines == ["number,problem,variant,parameters",
                         "dev09-1,dev09,1,h=20","dev09-2,dev09,2,h=25",""]) :-
    with_sheets(dev09, [given([front])], [h-[20,25]], [], Folder,
                text(Folder, 'list.csv', Text)),
    split_string(Text, "\n", "", Lines).

%   What a notice is about it says first.
test(about, [true(Said == ["one: two: wrote x"])]) :-
    said_about(one, said_about(two, true)),
    said_about(one,
               ( about(one),
                 spoken_lines(informational, sanggwan(wrote(x)),
                              ['two: wrote x'], Lines) )),
    print_lines(Lines, Text),
    \+ about(_),
    split_string(Text, "", "\n ", Said).

print_lines(Lines, Text) :-
    with_output_to(string(Text),
                   print_message_lines(current_output, '', Lines)).

test(same_bytes, Text1 == Text2) :-
    Items = [given([front,top,right]),ask(draw(penetration))],
    with_sheets(fig12, Items, [r-[14]], [], Folder1,
                text(Folder1, 'fig12-1-answer.svg', Text1)),
    with_sheets(fig12, Items, [r-[14]], [], Folder2,
                text(Folder2, 'fig12-1-answer.svg', Text2)).

%   The gallery has the sheets of the first collection as they are made: its
%   problem fig12 again.
test(gallery, [forall(member(Kind, [question,answer])), true(Made == Kept)]) :-
    collection_problem(fig12, Items, Variants),
    format(atom(Local), 'fig12-1-~w.svg', [Kind]),
    with_sheets(fig12, Items, Variants, [], Folder,
                text(Folder, Local, Made)),
    absolute_file_name(sanggwan('docs/gallery/problems'), Gallery),
    text(Gallery, Local, Kept).

collection_problem(Name, Items, [Parameter-[Value]]) :-
    absolute_file_name(sanggwan('facts/problems/collection.pl'), File),
    read_file_to_terms(File, Facts, [encoding(utf8)]),
    memberchk(problem(Name, _, Items), Facts),
    memberchk(variant(Name, Parameter, [Value|_]), Facts).

%   No number stands on another one in any answer of the gallery, and question
%   and answer have their views in the same places.
gallery_answer(Question, Answer) :-
    absolute_file_name(sanggwan('docs/gallery/problems'), Gallery),
    directory_files(Gallery, Locals0),
    msort(Locals0, Locals),
    member(Local, Locals),
    atom_concat(Number, '-1-answer.svg', Local),
    atom_concat(Number, '-1-question.svg', Asked),
    text(Gallery, Asked, Question),
    text(Gallery, Local, Answer).

test(numbers_apart, true(Overlaps-Count == []-14)) :-
    findall(Answer, gallery_answer(_, Answer), Answers),
    length(Answers, Count),
    aggregate_all(count,
                  ( member(Answer, Answers), number_box(Answer, _) ),
                  Numbers),
    Numbers > 300,
    findall(One-Two,
            ( member(Answer, Answers),
              findall(Box, number_box(Answer, Box), Boxes),
              append(_, [One|Rest], Boxes),
              member(Two, Rest),
              overlap(One, Two) ),
            Overlaps).

%   number_box(Text, Box): of a number beside a point, 2 mm high.

number_box(Text, box(X1,Y1,X2,Y2)) :-
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    sub_string(Line, _, _, _, "font-size=\"2.777\""),
    split_string(Line, "\"", "", ["<text x=",XText,_,YText|_]),
    number_string(X, XText),
    number_string(Y, YText),
    split_string(Line, "<>", "", [_,_,String|_]),
    lettering_width(String, 2.0, Width),
    X1 is X-Width/2,
    X2 is X+Width/2,
    Y1 is Y-2.0,
    Y2 = Y.

overlap(box(A1,B1,A2,B2), box(C1,D1,C2,D2)) :-
    A1 < C2, C1 < A2, B1 < D2, D1 < B2.

test(same_places, [forall(gallery_answer(Question, Answer)),
                   true(High1 =:= High2)]) :-
    highest(Question, "front", High1),
    highest(Answer, "front", High2).

test(in_korean) :-
    Items = [ given([front]), text(en, 'Where?'), text(ko, '어디인가?') ],
    with_sheets(dev09, Items, [], [language(ko)], Folder,
                text(Folder, 'dev09-1-question.svg', Text)),
    sub_string(Text, _, _, _, "어디인가?"),
    \+ sub_string(Text, _, _, _, "Where?"),
    !.

%   So is the table of a pattern, whatever the language of people is.
test(table_in_korean, true(Same == false)) :-
    Items = [given([front]), ask(develop(1))],
    with_sheets(dev10, Items, [], [language(ko)], Folder1,
                text(Folder1, 'dev10-1-development-1.svg', Text1)),
    with_sheets(dev10, Items, [], [language(en)], Folder2,
                text(Folder2, 'dev10-1-development-1.svg', Text2)),
    (   Text1 == Text2
    ->  Same = true
    ;   Same = false
    ).

%   The view from above stands above the front view, or below it.
test(angles) :-
    Items = [given([front,top])],
    with_sheets(dev10, Items, [], [angle(first)], Folder1,
                text(Folder1, 'dev10-1-question.svg', First)),
    with_sheets(dev10, Items, [], [angle(third)], Folder2,
                text(Folder2, 'dev10-1-question.svg', Third)),
    highest(First, "front", FrontFirst),
    highest(First, "top", TopFirst),
    highest(Third, "front", FrontThird),
    highest(Third, "top", TopThird),
    TopFirst > FrontFirst,
    TopThird < FrontThird.

%   highest(Text, View, Y): of the lines in the group of that view, on the sheet
%   (y runs down).

highest(Text, View, Y) :-
    format(string(Group), "<g id=\"~s\" class=\"view\">", [View]),
    sub_string(Text, Start, _, _, Group),
    sub_string(Text, Start, _, 0, Rest),
    sub_string(Rest, End, _, _, "class=\"view\""),
    End > 60,
    sub_string(Rest, 0, End, _, Own),
    !,
    places(Own, "", Places),
    findall(Y0,
            ( member(Place, Places),
              split_string(Place, ",", "", [_,Text0]),
              number_string(Y0, Text0) ),
            Ys),
    min_list(Ys, Y).

wrong([colour(1)], fact(colour, 1)).
wrong([problem(a, 'b.pl', [given(inside)])], item(given(inside))).
wrong([problem(a, 'b.pl', x)], item(x)).
wrong([problem(a, b(1), [])], model(b(1))).
wrong([problem(a, 'b.pl', []),problem(a, 'c.pl', [])], twice(a)).
wrong([problem(a, 'b.pl', []),variant(c, r, [1])], no_problem(c)).
wrong([problem(a, 'b.pl', [])], no_sheet(a)).
wrong([problem(a, 'b.pl', []),sheet('B7', [a], [])], paper('B7')).
wrong([problem(a, 'b.pl', []),variant(a, r, x)], values(x)).
wrong([problem(_, 'b.pl', [])], variable).
wrong([problem(a, 'b.pl', [ask(measure(weight(1), mm, 1))])],
      measure(weight(1))).
wrong([problem(a, 'b.pl', [ask(measure(area(x), mm2, 1))])], measure(area(x))).
wrong([problem(a, 'b.pl', [ask(measure(area(1), mm, 1))])],
      unit(area(1), mm, [mm2,cm2,m2])).
wrong([problem(a, 'b.pl', [ask(measure(area(1), mm2, 0))])],
      tolerance(area(1), 0)).
wrong([problem(a, 'b.pl', [given([top]),blank(top)])], all_blank).
wrong([problem(a, 'b.pl', [given([front,top]),
                           ask(measure(coordinate(1,x), mm, 1))])],
      no_view(coordinate(1,x), [right,left])).
wrong([problem(a, 'b.pl', [planes(w)])], item(planes(w))).
wrong([problem(a, 'b.pl', [hide(line)])], item(hide(line))).
wrong([problem(a, 'b.pl', [ask(draw(penetration, []))])],
      item(ask(draw(penetration, [])))).
wrong([problem(a, 'b.pl', [given([front]), ask(draw(penetration, [top]))])],
      not_given(top, [front])).
wrong([problem(a, 'b.pl', [show(penetration), ask(draw(penetration))])],
      shown_and_asked).
wrong([problem(a, 'b.pl', [show(penetration), hide(penetration)])],
      shown_and_asked).
wrong([variant(a, in(r, [1,2]), [3])], seed([3])).
wrong([variant(a, in(r, x), seed(1))], values(x)).
wrong([variant(a, r, between(1, 2, 0))], values(between(1, 2, 0))).
wrong([pupils([a,a])], pupils([a,a])).
wrong([problem(a, 'b.pl', [planes(straight, 3)])], item(planes(straight,3))).
wrong([problem(a, 'b.pl', [given([front]),blank(inside)])],
      item(blank(inside))).

test(wrong, [forall(wrong(Facts, What)),
             error(model_error(problem(What)), location(_, _, 1))]) :-
    tmp_file(problems, Folder),
    make_directory_path(Folder),
    directory_file_path(Folder, 'wrong.pl', File),
    setup_call_cleanup(open(File, write, Out),
                       forall(member(Fact, Facts),
                              format(Out, '~k.~n', [Fact])),
                       close(Out)),
    call_cleanup(problem_sheets(File, Folder, []),
                 delete_directory_and_contents(Folder)).

%   What the model does not have is told with the number of the sheet, at the
%   place of the problem.

unfit(fig12, ask(measure(area(7), mm2, 1)), no_segment(7)).
unfit(fig12, ask(develop(7)), no_segment(7)).
unfit(fig08, ask(develop(2)), no_pattern(2)).
unfit(fig08, ask(measure(area(2), mm2, 1)), no_measure(area(2))).
unfit(fig12, part(7, en, 'pipe'), no_segment(7)).
unfit(fig10, ask(measure(edge(1, 1, 99), mm, 1)), no_vertex(1, 99)).
unfit(fig10, ask(measure(sector(1), deg, 1)), no_measure(sector(1))).
unfit(fig10, ask(measure(generator(1, 1), mm, 1)),
      no_measure(generator(1, 1))).
unfit(fig12, ask(measure(coordinate(99, x), mm, 1)),
      no_measure(coordinate(99, x))).
unfit(fig12, ask(measure(area(1), mm2, 1.0e-6)), too_fine(area(1), 1.0e-6)).

test(unfit, [forall(unfit(Name, Item, What)),
             error(model_error(problem(of(Number, model_error(problem(What))))),
                   location(_, 1, 1))]) :-
    atom_concat(Name, '-1', Number),
    with_sheets(Name, [given([front,top,right]),Item], [], [], _, true).

test(unfit_told, [forall(unfit(_, _, What))]) :-
    phrase(problem_en(What), [_,_|_]),
    phrase(problem_ko(What), [_,_|_]).

%   Each is told in both languages.
test(told, [forall(wrong(_, What))]) :-
    phrase(problem_en(What), [_,_|_]),
    phrase(problem_ko(What), [_,_|_]).

%   What teachers write (strings, a range, a variable, one item, small letters);
%   the same seed gives the same order, another one another.

written(Seed, [ problem(p1, Model, [given([front]), text(en, "Draw."),
                                    part(1, en, "oblique cone")]),
                variant(p1, in('$VAR'('E'), '..'(10, 19)), seed(Seed)),
                sheet(a4, [p1], title_block([class,name,number,date])),
                pupils(['Kim','Lee, J.','Park']) ]) :-
    model(dev10, Model).

read_problems(Facts, Problems, Pupils) :-
    tmp_file(problems, File),
    setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                       forall(member(Fact, Facts),
                              format(Out, '~@.~n',
                                     [write_term(Fact, [quoted(true),
                                                        numbervars(true),
                                                        ignore_ops(true)])])),
                       close(Out)),
    call_cleanup(problems_read(File, Problems, Pupils), delete_file(File)).

test(seed, true) :-
    findall(Values,
            ( member(Seed, [7,7,8]),
              written(Seed, Facts),
              read_problems(Facts, [Problem], _),
              Problem = problem(p1, _, Items, Variants, Sheet, _),
              memberchk(text(en, 'Draw.'), Items),
              Sheet == sheet(a4, [fields([class,name,number,date])]),
              findall(V, member([e=V], Variants), Values) ),
            [First,Same,Other]),
    First == Same,
    First \== Other,
    numlist(10, 19, All),
    First \== All,
    msort(First, All),
    msort(Other, All).

%   Each pupil has a sheet; the fields to fill in have their names.
test(pupils, true(List == ["pupil,dev10","Kim,dev10-1","\"Lee, J.\",dev10-2",
                           "Park,dev10-1",""])) :-
    with_facts([ pupils(['Kim','Lee, J.','Park']) ], 'A4', dev10,
               [given([front])], [e-[10,20]],
               [title_block([class,name,number,date,'x'])], Folder0, Fault),
    Fault = model_error(problem(item(fields(_)))),
    nonvar(Folder0),
    with_facts([ pupils(['Kim','Lee, J.','Park']) ], 'A4', dev10,
               [given([front])], [e-[10,20]],
               [title_block([class,name,number,date])], Folder, none),
    text(Folder, 'pupils.csv', Text),
    split_string(Text, "\n", "", List),
    text(Folder, 'dev10-1-question.svg', Sheet),
    has(Sheet, ">Class<", true),
    has(Sheet, ">Pupil<", true),
    has(Sheet, ">Drawn by<", false),
    delete_directory_and_contents(Folder).

%   The title block of A4 is as wide as the paper: the question stands above it.

test(question_above_title_block, [true(Question < Block)]) :-
    with_sheets_on('A4', fig12,
                   [given([front]), ask(draw(penetration)), text(en, 'Draw!')],
                   [r-[12]], [], Folder,
                   text(Folder, 'fig12-1-question.svg', Text)),
    height_of(Text, 'Draw!', Question),
    height_of(Text, 'Drawn by', Block).

%   height_of(Text, Word, Y): where the Word stands on the sheet, from the top.

height_of(Text, Word, Y) :-
    split_string(Text, "\n", "", Lines),
    format(string(End), ">~w</text>", [Word]),
    once(( member(Line, Lines), sub_string(Line, _, _, _, End) )),
    split_string(Line, "\"", "", [_,_,_,Value|_]),
    number_string(Y, Value).

:- end_tests(problem_sheet).
