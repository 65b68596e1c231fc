/* Texts and terms of others, made fit to be shown. */
:- module(test_plain, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(yall)).
:- use_module(rules(plain)).

%   hidden(Low, High): what is shown as U+FFFD, besides control characters.

hidden(0x80, 0x9f).
hidden(0x61c, 0x61c).
hidden(0x200b, 0x200b).
hidden(0x200e, 0x200f).
hidden(0x2028, 0x202e).
hidden(0x2060, 0x206f).
hidden(0xfeff, 0xfeff).
hidden(0xfff9, 0xfffb).
hidden(0xe0000, 0xe007f).

is_hidden(Code) :-
    hidden(Low, High),
    Code >= Low,
    Code =< High,
    !.

code(Code) :-
    (   between(1, 0x2100, Code)
    ;   member(Near, [0xfeff,0xfff9,0xfffb,0xe0000,0xe007f,0x1f600,0xac00]),
        member(By, [-1,0,1]),
        Code is Near+By
    ).

shown(Code, Shown) :-
    (   Code < 0x20
    ->  Shown is 0x2400+Code
    ;   Code =:= 0x7f
    ->  Shown = 0x2421
    ;   is_hidden(Code)
    ->  Shown = 0xfffd
    ;   Shown = Code
    ).

length_of(Term, Length) :-
    write_length(Term, Length, [quoted(true)]).

%   deep(N, Term): terms in one another.

deep(0, x) :-
    !.
deep(N, f(Term)) :-
    N1 is N-1,
    deep(N1, Term).

depth(Term, Depth) :-
    (   compound(Term)
    ->  arg(1, Term, Inner),
        depth(Inner, Depth0),
        Depth is Depth0+1
    ;   Depth = 0
    ).

json_of(Term, Encoding, Text) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(Encoding)]),
        ( plain_json(Out, json_write_dict(current_output, Term)),
          close(Out),
          setup_call_cleanup(open(File, read, In, [encoding(utf8)]),
                             read_string(In, _, Text),
                             close(In)) ),
        delete_file(File)).

:- begin_tests(plain).

test(characters, true(Wrong == [])) :-
    findall(Code,
            ( code(Code),
              string_codes(Text, [0'a,Code]),
              plain_text(Text, Plain),
              shown(Code, Shown),
              \+ string_codes(Plain, [0'a,Shown]) ),
            Wrong).
test(atom, Plain == "a\u2409b") :-
    plain_text('a\tb', Plain).

%   Of JSON too: what is hidden is escaped, and comes back.
test(json, [ forall(member(Encoding, [utf8,ascii])), true(Wrong == []) ]) :-
    findall(Code,
            ( ( between(1, 500, Code) ; member(Code, [0x7e,0x7f,0x80,0x200e,
                                                     0xac00,0xfeff,0xffff,
                                                     0x10000,0x1f600,
                                                     0xe0001]) ),
              string_codes(Was, [0'a,Code,0'z]),
              json_of(Was, Encoding, Text),
              \+ ( string_codes(Text, Codes),
                   forall(member(C, Codes),
                          ( C =\= 0x7f,
                            \+ is_hidden(C),
                            ( Encoding == utf8 -> true ; C < 0x7f ) )),
                   atom_string(Json, Text),
                   atom_json_dict(Json, Read, []),
                   same_text(Read, Was) ) ),
            Wrong).

%   library(http/json) may leave two halves of a character.
same_text(Text, Was) :-
    (   Text == Was
    ->  true
    ;   string_codes(Text, [0'a,High,Low,0'z]),
        Code is 0x10000 + ((High-0xd800)<<10) + (Low-0xdc00),
        string_codes(Was, [0'a,Code,0'z])
    ).

test(small_term_stays, [ forall(member(Term,
        [ a, "x", 12, 1.5, 1r3, f(a,"b",[1,2|c]), 'A b', [], f(), "" ])),
                         true(Plain == Term) ]) :-
    plain_term(Term, Plain).
test(kinds, Plain == f('a\u2409b',"c\u240ad",'\ufffd'(x))) :-
    plain_term(f('a\tb',"c\nd",'\u202e'(x)), Plain).
test(shown_in_2000, [ forall(member(Kind, [ deep,wide,long,number,shared,atoms,
                                            cyclic ])) ]) :-
    large(Kind, Term),
    plain_term(Term, Plain),
    length_of(Plain, Length),
    Length =< 2000.
test(as_deep, Depths == [11,12,12,12]) :-
    findall(Depth,
            ( member(N, [11,12,13,40]),
              deep(N, Term),
              plain_term(Term, Plain),
              depth(Plain, Depth) ),
            Depths).
test(dots_where_it_is_deeper, Inner == '...') :-
    deep(13, Term),
    plain_term(Term, Plain),
    innermost(Plain, Inner).
test(as_wide, Lengths == [99-9,100-0,101-'...']) :-
    findall(N-Last,
            ( member(N, [99,100,101]),
              numlist(1, N, Ns0),
              maplist([X,Y]>>( Y is X mod 10 ), Ns0, Ns),
              plain_term(Ns, Plain),
              length(Plain, M),
              assertion(( N =< 100 -> M =:= N ; M =:= 101 )),
              last(Plain, Last) ),
            Lengths).
test(as_long, Found == [500-whole,501-cut]) :-
    findall(N-How,
            ( member(N, [500,501]),
              length(Codes, N),
              maplist(=(0'x), Codes),
              string_codes(Text, Codes),
              plain_term(Text, Plain),
              (   Plain == Text
              ->  How = whole
              ;   How = cut,
                  string_length(Plain, 500),
                  sub_string(Plain, 372, 3, 125, "...")
              ) ),
            Found).
%   What is still too much is shown shorter.
test(shorter, [ forall(member(Many-Each, [4-whole,5-cut])),
                true(Found == Each) ]) :-
    length(Codes, 480),
    maplist(=(0'x), Codes),
    string_codes(Text, Codes),
    length(Texts, Many),
    maplist(=(Text), Texts),
    plain_term(Texts, [First|_]),
    ( First == Text -> Found = whole ; Found = cut ).

test(small_is_not_cut, Cut == Term) :-
    numlist(1, 1000, Term),
    cut_term(Term, Cut).
test(long_list_is_cut, N-Last == 201-'...') :-
    numlist(1, 100 000, List),
    cut_term(f(List), f(Cut)),
    length(Cut, N),
    last(Cut, Last).
test(cut_of_an_error, true) :-
    length(List, 300 000),
    maplist(=(f(x)), List),
    cut_term(error(type_error(t, List), _), Cut),
    Cut = error(type_error(t, Few), Context),
    var(Context),
    length(Few, 201).

test(lines, Plain == ["~w"-["a\u2409"],ansi(bold,"~w",["b\u240a"]),nl,
                      "~w"-["c\u240a"]]) :-
    plain_lines(error, ["~w"-["a\t"],ansi(bold,"~w",["b\n"]),nl,"~w"-"c\n"],
                Plain0),
    maplist(one_value, Plain0, Plain).
test(help_is_not_cut, Plain == ["~w"-["a\t"]]) :-
    plain_lines(help, ["~w"-["a\t"]], Plain).

one_value("~w"-Value, "~w"-[Value]) :-
    string(Value),
    !.
one_value(Element, Element).

:- end_tests(plain).

innermost(Term, Inner) :-
    (   compound(Term)
    ->  arg(1, Term, Next),
        innermost(Next, Inner)
    ;   Inner = Term
    ).

large(deep, Term) :-
    deep(5000, Term).
large(wide, Term) :-
    numlist(1, 5000, List),
    Term =.. [f|List].
large(long, Text) :-
    length(Codes, 100 000),
    maplist(=(0'\\), Codes),
    string_codes(Text, Codes).
large(number, Number) :-
    Number is 7**20000.
large(shared, Term) :-
    shared(40, x, Term).
large(atoms, Terms) :-
    length(Codes, 70),
    maplist(=(0'\\), Codes),
    atom_codes(Atom, Codes),
    length(Terms, 300),
    maplist(=(f(Atom,Atom)), Terms).
large(cyclic, Term) :-
    Term = f(Term,[Term|Term]).

shared(0, Term, Term) :-
    !.
shared(N, Term0, Term) :-
    N1 is N-1,
    shared(N1, f(Term0,Term0), Term).
