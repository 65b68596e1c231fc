/* What numbers are taken for: the last that is right and the first that is not,
   for every bound that stands in a rule. */
:- module(test_corners, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(http/json)).
:- use_module(rules(angle)).
:- use_module(rules(formula)).
:- use_module(rules(plain)).
:- use_module(rules(space_limit)).
:- use_module(rules(store)).
:- use_module(rules(command/sheet_options)).
:- use_module(rules(drawing/ink)).
:- use_module(rules(drawing/style)).
:- use_module(rules(drawing/style_file)).
:- use_module(rules(pattern/pattern_paper)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(primitive/primitive_argument)).
:- use_module(rules(sheet/sheet)).
:- use_module(rules(sheet/hangul)).
:- use_module(rules(unfolding/unfold_how)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   corner(Right, Wrong): the goal Right succeeds; Wrong fails, or is an error.

corner(sg_style_file:is_property(width(100)),
       sg_style_file:is_property(width(100.0001))).
corner(sg_style_file:is_property(width(5.0e-324)),
       sg_style_file:is_property(width(0))).
corner(sg_style_file:is_property(pen(1)), sg_style_file:is_property(pen(0))).
corner(sg_style_file:is_property(pen(255)),
       sg_style_file:is_property(pen(256))).
corner(layer('ABCDEFGHIJKLMNOPQRSTUVWXYZ_-$12'),
       layer('ABCDEFGHIJKLMNOPQRSTUVWXYZ_-$123')).
corner(layer('A'), layer('')).
corner(layer('a$'), layer('a~')).
corner(layer('z'), layer('\x80\')).
corner(layer('0'), layer('\xe9\')).
corner(sg_colour:byte(255), sg_colour:byte(256)).
corner(sg_colour:byte(0), sg_colour:byte(-1)).
corner(ink(100, 1), ink(100.0001, 1)).
corner(ink(5.0e-324, 1), ink(0, 1)).
corner(ink(1, 1), ink(1, 0)).
corner(ink(1, 255), ink(1, 256)).
corner(sg_ink:run_thousandths(1000, 1_000_000),
       sg_ink:run_thousandths(1000.0001, _)).
corner(sg_ink:run_thousandths(0.0001, 1), sg_ink:run_thousandths(0, _)).
corner(sg_ink:type_runs([1,1], 1, _), sg_ink:type_runs([1,1,1], 1, _)).
corner(sg_pattern_paper:page_size(50-50, _, _),
       sg_pattern_paper:page_size(50-49.9999, _, _)).
corner(sg_pattern_paper:page_size(20000-50, _, _),
       sg_pattern_paper:page_size(20000.0001-50, _, _)).
corner(sg_sheet:size_option([size('100000x0.001')], _, _, _),
       sg_sheet:size_option([size('100000x0.0009')], _, _, _)).
corner(sg_sheet:size_option([size(0.001-100000)], _, _, _),
       sg_sheet:size_option([size(1-100000.0001)], _, _, _)).
corner(sg_sheet_options:scale_form("1:9.9999e149", _),
       sg_sheet_options:scale_form("1:1e150", _)).
corner(sg_sheet_options:scale_form("9.9999e149:1", _),
       sg_sheet_options:scale_form("1e150:1", _)).
corner(number(facets, 3), number(facets, 2)).
corner(number(facets, 1_000_000), number(facets, 1_000_001)).
corner(number(count, 1), number(count, 0)).
corner(number(count, 1_000_000), number(count, 1_000_001)).
corner(number(length, 5.0e-324), number(length, 0)).
corner(number(radius, 0), number(radius, -5.0e-324)).
corner(number(factor, 0), number(factor, -5.0e-324)).
corner(number(turn, 360), number(turn, 360.0001)).
corner(number(turn, 5.0e-324), number(turn, 0)).
corner(sg_unfold_how:of_type(size, 0), sg_unfold_how:of_type(size, -0.0001)).
corner(sg_unfold_how:of_type(part, 0), sg_unfold_how:of_type(part, -0.0001)).
corner(sg_unfold_how:of_type(part, 1), sg_unfold_how:of_type(part, 1.0001)).
corner(sg_unfold_how:of_type(count, 2), sg_unfold_how:of_type(count, 1)).
corner(sg_unfold_how:of_type(count, 3600), sg_unfold_how:of_type(count, 3601)).
corner(syllable(0xac00, _, _), syllable(0xabff, _, _)).
corner(syllable(0xd7a3, _, _), syllable(0xd7a4, _, _)).
corner(fact(v(1,2147483647,0,0,0)), fact(v(1,2147483648,0,0,0))).
corner(fact(v(2147483647,1,0,0,0)), fact(v(2147483648,1,0,0,0))).
corner(fact(v(1,1,0,0,0)), fact(v(1,0,0,0,0))).
corner(fact(v(1,1,1.0e90,0,0)), fact(v(1,1,1.0000001e90,0,0))).
corner(fact(v(1,1,0,-1.0e90,0)), fact(v(1,1,0,-1.0000001e90,0))).
corner(fact(v(1,1,0,0,1.0e90)), fact(v(1,1,0,0,1.0000001e90))).
corner(primitive(elbow(pieces(2), 90)), primitive(elbow(pieces(1), 90))).
corner(primitive(elbow(pieces(2), 168.5)), primitive(elbow(pieces(2), 168.6))).
corner(primitive(elbow(pieces(3), 337)), primitive(elbow(pieces(3), 337.1))).
corner(primitive(wye(169.9999)), primitive(wye(170))).
corner(primitive(way_turned(168)), primitive(way_turned(169))).
corner(primitive(prism([[0,0],[1,0],[0,1]])), primitive(prism([[0,0],[1,0]]))).
corner(primitive(turning(360)), primitive(turning(360.0001))).

layer(Name) :-
    sg_style:layer_name(Name).

ink(Width, Pen) :-
    sg_ink:style_ink(style(Width,black,solid,Pen,'0'), _).

number(Type, Value) :-
    sg_primitive_argument:argument_number(Type, Value, _, _).

fact(Fact) :-
    in_new_world(assert_fact(Fact)).

primitive(Short) :-
    term_of(Short, Term),
    in_new_world(add_primitive(Term, _)).

term_of(elbow(Pieces, Angle),
        elbow(diameter(0.01), radius(9), Pieces, angle(Angle), ends(9),
              facets(4))).
term_of(wye(Angle),
        wye(diameter(0.01), angle(Angle), stem(9), legs(9), facets(4))).
term_of(way_turned(Degrees),
        mitred_pipe(diameter(0.001), through([[0,0,0],[0,0,9],[X,0,Z]]),
                    facets(4))) :-
    X is 9*sin(Degrees*pi/180),
    Z is 9+9*cos(Degrees*pi/180).
term_of(prism(Points), prism(outline(Points), height(1))).
term_of(turning(Degrees),
        turning(outline([[1,0],[2,0],[1,1]]), angle(Degrees), facets(6))).

right(Goal) :-
    catch(Goal, error(Error, _),
          ( print_message(error, format('~p: ~p', [Goal,Error])), fail )).

wrong(Goal) :-
    \+ catch(Goal, error(_, _), fail).

:- begin_tests(corners).

test(right, forall(corner(Right, _))) :-
    once(right(Right)).
test(wrong, forall(corner(_, Wrong))) :-
    wrong(Wrong).

% --- plain texts: Unicode's own names of what is not seen

unseen(Code) :-
    member(From-To, [ 0-0x1f, 0x7f-0x9f,            % control characters
                      0x61c-0x61c, 0x200e-0x200f,   % marks of direction
                      0x202a-0x202e, 0x2066-0x2069, % its embeddings, isolates
                      0x200b-0x200b, 0xfeff-0xfeff, % spaces without width
                      0x2028-0x2029,                % line and paragraph
                      0x2060-0x2065, 0x206a-0x206f, % what is for machines
                      0xfff9-0xfffb,                % annotations
                      0xe0000-0xe007f ]),           % tags
    between(From, To, Code).

stands_for(Code, Shown) :-
    (   Code < 0x20
    ->  Shown is 0x2400+Code
    ;   Code =:= 0x7f
    ->  Shown = 0x2421
    ;   unseen(Code)
    ->  Shown = 0xfffd
    ;   Shown = Code
    ).

test(plain_codes, Wrong == []) :-
    findall(Code,
            ( ( between(1, 0x2fff, Code)
              ; between(0xd7f0, 0xd7ff, Code)
              ; between(0xe000, 0xe010, Code)
              ; between(0xfe00, 0x10010, Code)
              ; between(0xdfff0, 0xe0100, Code)
              ; member(Code, [0x10fffe,0x10ffff])
              ),
              char_code(Char, Code),
              plain_text(Char, Plain),
              string_codes(Plain, [Shown|More]),
              stands_for(Code, Wanted),
              \+ ( Shown == Wanted, More == [] ) ),
            Wrong).

% JSON reads the same text back, and nothing of it is unseen.
test(json_codes, [ forall(member(Encoding, [utf8,ascii])), Wrong == [] ]) :-
    findall(Code,
            ( member(Code, [ 0x1f,0x20,0x21,0x22,0x5c,0x7e,0x7f,0x80,0x9f,
                             0xa0,0xff,0x100,0x61c,0x200b,0x202e,0x2030,
                             0xac00,0xd7ff,0xe000,0xfeff,0xfffd,0xffff,
                             0x10000,0x103ff,0x10400,0xe0001,0x1f600,
                             0x10ffff ]),
              string_codes(Text, [0'a,Code,0'b]),
              \+ json_back(Encoding, Text) ),
            Wrong).

json_back(Encoding, Text) :-
    tmp_file_stream(File, Out, [encoding(Encoding)]),
    call_cleanup(plain_json(Out, json_write(current_output, Text)), close(Out)),
    read_file_to_codes(File, Codes, [encoding(utf8)]),
    delete_file(File),
    json_text(Codes, Read),
    string_codes(Text, Read),
    (   Encoding == ascii
    ->  forall(member(Code, Codes), Code < 0x7f)
    ;   \+ ( member(Code, Codes), Code > 0x20, unseen(Code) )
    ).

%   json_text(Codes, Text): two escapes that are halves are one code.

json_text(Codes, Text) :-
    append([0'"|Inner], [0'"], Codes),
    phrase(json_codes(Text), Inner).

json_codes([Code|Codes]) -->
    unit(High),
    { between(0xd800, 0xdbff, High) },
    !,
    unit(Low),
    { Code is 0x10000 + (High-0xd800)*0x400 + Low-0xdc00 },
    json_codes(Codes).
json_codes([Code|Codes]) -->
    unit(Code),
    !,
    json_codes(Codes).
json_codes([Code|Codes]) -->
    "\\",
    !,
    [Code],
    json_codes(Codes).
json_codes([Code|Codes]) -->
    [Code],
    !,
    json_codes(Codes).
json_codes([]) -->
    [].

unit(Unit) -->
    "\\u",
    [A,B,C,D],
    { number_codes(Unit, [0'0,0'x,A,B,C,D]) }.

% --- how much of a term is shown

terms_shown(N, Shown) :-
    length(Xs, N),
    maplist(=(x), Xs),
    Term =.. [f|Xs],
    plain_term(Term, Plain),
    Plain =.. [f|Ys],
    length(Ys, Shown).

test(arguments_shown, Shown == [100,101-'...',101-'...']) :-
    findall(S, ( member(N, [100,101,102]), shown_of(N, S) ), Shown).

% Whatever a term is, what is shown of it is short, and has both ends of a text.
test(shown_is_short, Wrong == []) :-
    numlist(1, 30, Few),
    numlist(1, 5000, Many),
    foldl([_,T,f(T,T)]>>true, [1,2,3,4,5,6,7,8,9,10,11,12,13,14,15], x, Bushy),
    foldl([_,T,[T]]>>true, Many, x, Deep),
    length(Square, 30),
    maplist(=(Few), Square),
    length(Codes, 50000),
    maplist(=(0'a), Codes),
    atom_codes(Atom, Codes),
    string_codes(String, Codes),
    Number is 3**50000,
    Fraction is 1 rdiv Number,
    compound_name_arguments(Wide, f, Many),
    compound_name_arguments(Named, Atom, [x]),
    findall(Term,
            ( member(Term, [ Bushy,Deep,Square,Atom,String,Number,Fraction,
                             Codes,Wide,Named,[Atom|Many],Many-String ]),
              plain_term(Term, Plain),
              format(string(Shown), "~p", [Plain]),
              string_length(Shown, Length),
              \+ ( Length =< 2000, sub_string(Shown, _, _, _, "...") )
            ), Wrong).
test(both_ends, [ forall(member(Kind, [atom_string,string])), true ]) :-
    length(As, 400),
    length(Bs, 400),
    maplist(=(a), As),
    maplist(=(b), Bs),
    append(As, Bs, Letters),
    atomic_list_concat(Letters, Atom),
    (   Kind == string
    ->  atom_string(Atom, Text)
    ;   Text = Atom
    ),
    plain_term(Text, Plain),
    atom_length(Plain, 500),
    sub_atom(Plain, 0, 372, _, First),
    sub_atom(Plain, _, 128, 0, Last),
    sub_atom(First, _, 2, 0, aa),
    sub_atom(Last, 0, 4, _, '...b').
test(as_it_is, Terms == Plain) :-
    Terms = [ [],'[]',"[]",'',"",1,-2.5,1r3,a+b,f(),'a b'("c",X,X),{a},
              [a|_],point{x:1} ],
    maplist(plain_term, Terms, Plain).

% What is cut of an error shows the same, and is small.
test(cut_is_shown_the_same, Wrong == []) :-
    numlist(1, 100_000, Many),
    Wide =.. [f|Many],
    findall(Term,
            ( member(Term, [ Many,Wide,g(Many,b),[Many,x,Wide],a,"b",1.5,[],
                             [a|b],f(),box(size([Many|Many],1,_)) ]),
              cut_term(Term, Cut),
              plain_term(Term, Plain),
              plain_term(Cut, PlainCut),
              \+ ( Plain =@= PlainCut,
                   format(string(Text), "~w", [Cut]),
                   string_length(Text, Length),
                   Length < 5000 ) ),
            Wrong).

% What is not large is not cut.
test(cut_is_large, Cut == Term) :-
    numlist(1, 10_000, Many),
    Term = error(f(Many, 0'a, "b"), [Many|_]),
    cut_term(Term, Cut).

% Terms that share their parts, or have themselves as one, have no end of them.
test(shared_is_short, Bad == []) :-
    findall(I, between(1, 40, I), Few),
    foldl([_,T,T1]>>( length(T1, 100), maplist(=(T), T1) ), Few, x, Shared),
    Twice = [Twice|Twice],
    numlist(1, 100_000, Many),
    findall(N,
            ( nth1(N, [Shared,Twice,f(Many,Twice),f(Many,Shared)], Term),
              \+ ( call_with_inference_limit(
                       ( plain_term(Term, Plain), cut_term(Term, Cut) ),
                       20_000_000, Within),
                   Within \== inference_limit_exceeded,
                   write_length(Plain, _, [max_length(2000)]),
                   term_size(Cut, Size),
                   Size < 2_000_000 ) ),
            Bad).

% Whether there is a formula in a long list takes no stack.
test(formula_in_a_list, true) :-
    numlist(1, 1_000_000, Many),
    append(Many, [param(a)], More),
    with_stack_limit(150_000_000,
                     ( \+ has_formula(point(Many)),
                       has_formula(point(More)),
                       formed(point(More), [a,2]>>true, Point) )),
    Point = point(Formed),
    last(Formed, 2).

shown_of(N, Shown) :-
    terms_shown(N, Count),
    (   Count =:= N, N =< 100
    ->  Shown = Count
    ;   Shown = Count-(...)
    ).

% --- facets of an arc: the least number whose chords stay within a tolerance

test(chord_facets, Wrong == []) :-
    findall(R-T-D-N,
            ( member(R, [0.001,1,50,1000]),
              member(T, [0.00001,0.001,0.1,1,5,2000]),
              member(D, [0.5,1,45,89,90,91,179,180,181,270,359,360]),
              chord_facets(R, T, D, N),
              \+ least(R, T, D, N) ),
            Wrong).

least(Radius, Tolerance, Degrees, N) :-
    stays(N, Radius, Tolerance, Degrees, 1.0000001),
    Fewer is N-1,
    \+ stays(Fewer, Radius, Tolerance, Degrees, 0.9999999).

stays(N, Radius, Tolerance, Degrees, Near) :-
    N > 0,
    Degrees < 180*N,
    Radius*(1-cos(Degrees*pi/180/N/2)) =< Tolerance*Near.

:- end_tests(corners).
