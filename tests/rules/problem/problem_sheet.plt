:- encoding(utf8).
/* Problem sheets: nothing of the answer is in the question, and the key is what
   closed forms say.
   covers: problem_drawing, problem_file, problem_point, problem_sheet */
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(message/problem_en)).
:- use_module(rules(message/problem_ko)).
:- use_module(rules(problem/problem_sheet)).

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
    model(Name, Model),
    findall(variant(Name, Parameter, Values),
            member(Parameter-Values, Variants),
            Rows),
    append([problem(Name, Model, Items)|Rows],
           [sheet(Paper, [Name], [angle(third)])], Facts),
    tmp_file(problems, Folder),
    make_directory_path(Folder),
    setup_call_cleanup(
        true,
        ( directory_file_path(Folder, 'one.pl', File),
          setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                             forall(member(Fact, Facts),
                                    format(Out, '~k.~n', [Fact])),
                             close(Out)),
          problem_sheets(File, Folder, Options),
          call(Goal) ),
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
            ( ( member(Word, ["penetration","construction"])
              ; member(Word, Places)
              ),
              sub_string(Asked, _, _, _, Word) ),
            Found).

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

%   Two equal cylinders meet in four arcs between two points that count once.
test(points_once, Count =:= 22) :-
    with_sheets(fig13, [given([front])], [r-[30]], [], Folder,
                key(Folder, 'fig13-1', Key)),
    Key.open_lines =:= 4,
    length(Key.points, Count).

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

test(same_bytes, Text1 == Text2) :-
    Items = [given([front,top,right]),ask(draw(penetration))],
    with_sheets(fig12, Items, [r-[14]], [], Folder1,
                text(Folder1, 'fig12-1-answer.svg', Text1)),
    with_sheets(fig12, Items, [r-[14]], [], Folder2,
                text(Folder2, 'fig12-1-answer.svg', Text2)).

test(in_korean) :-
    Items = [ given([front]), text(en, 'Where?'), text(ko, '어디인가?') ],
    with_sheets(dev09, Items, [], [language(ko)], Folder,
                text(Folder, 'dev09-1-question.svg', Text)),
    sub_string(Text, _, _, _, "어디인가?"),
    \+ sub_string(Text, _, _, _, "Where?"),
    !.

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

%   Each is told in both languages.
test(told, [forall(wrong(_, What))]) :-
    phrase(problem_en(What), [_,_|_]),
    phrase(problem_ko(What), [_,_|_]).

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
