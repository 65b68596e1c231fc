:- module(sg_unfold_names,
          [ trims/1,                    % +Options
            flag_wishes/2,              % +Options, -Flags
            flag_option/2,              % ?Name, ?Option
            flag_terms/3,               % +Option, +Text, -Terms
            in_file/5                   % +Files, +S, +Wish, +What, +Location
          ]).
:- use_module('../limits', [term_of_text/3]).
:- use_module('../model/model_text',
              [next_fact/3, place_location/3]).
:- use_module('../text_file', [with_text/4]).
:- use_module('../store', [unfolding/2]).
:- use_module('../unfolding/unfold_how', [how_wished_of_any/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> What the options of unfold say of faces, edges and segments.

Names and terms in the texts of --root, --cut, --keep, --remove, --order, --only
and --by; and where the fact of a model stands that cannot be met.
*/

%!  trims(+Options:list) is semidet.
%
%   True when Options, or the model, say that something is trimmed.

trims(Options) :-
    (   option(trim(_), Options)
    ->  true
    ;   how_wished_of_any(trim, _)
    ->  true
    ).

%!  flag_wishes(+Options:list, -Flags:list) is det.
%
%   Flags are root(P), cut(E) ... of Options, as unfold_wish.pl has them.
%
%   @error usage_error(unfold(What)): no_term(Option, Text),
%   no_names(Option, Text)

flag_wishes(Options, Flags) :-
    findall(Wishes, option_wishes(Options, Wishes), Lists),
    append(Lists, Flags).

option_wishes(Options, [root(Name)]) :-
    option(root(Text), Options),
    flag_terms('--root', Text, Names),
    (   Names = [Name]
    ->  true
    ;   usage_error(unfold(no_term('--root', Text)))
    ).
option_wishes(Options, Wishes) :-
    member(Name, [cut,keep,removed]),
    flag_option(Name, Option),
    option_texts(Name, Options, Texts),
    member(Text, Texts),
    flag_terms(Option, Text, Terms),
    findall(Wish, ( member(Term, Terms), Wish =.. [Name,Term] ), Wishes).
option_wishes(Options, [order(Names)]) :-
    option(order(Texts), Options),
    member(Text, Texts),
    flag_terms('--order', Text, Names).

option_texts(Name, Options, Texts) :-
    (   Name == removed
    ->  option(remove(Texts), Options)
    ;   Option =.. [Name,Texts],
        option(Option, Options)
    ).

%!  flag_option(?Name, ?Option) is nondet.
%
%   The option that says what a wish called Name says.

flag_option(root, '--root').
flag_option(cut, '--cut').
flag_option(keep, '--keep').
flag_option(order, '--order').
flag_option(removed, '--remove').

%!  flag_terms(+Option, +Text, -Terms:list) is det.
%
%   Terms are the names in Text, what Option says, with commas between them; one
%   with a capital needs no quotes, for there are no variables.
%
%   @error usage_error(unfold(What)), as flag_wishes/2

flag_terms(Option, Text, Terms) :-
    format(string(List), '[~w]', [Text]),
    (   catch(term_of_text(List, Terms0,
                          [ module(sg_model_syntax), cycles(false),
                            dotlists(false), variable_names(Names)
                          ]),
              error(syntax_error(_), _), fail),
        is_list(Terms0),
        Terms0 = [_|_],
        maplist(named_as_written, Names),
        ground(Terms0)
    ->  Terms = Terms0
    ;   memberchk(Option, ['--only','--by'])
    ->  usage_error(unfold(no_names(Option, Text)))
    ;   usage_error(unfold(no_term(Option, Text)))
    ).

named_as_written(Name=Name).

%!  in_file(+Files, +S, +Wish, +What, +Location) is failure.
%
%   Throw the error of what cannot be met, with the place of the fact in Files
%   that says Wish of segment S.

in_file(Files, S, Wish, What, Location) :-
    (   var(Location),
        wish_place(Files, S, Wish, Place)
    ->  place_location(Place, 2, Location)
    ;   true
    ),
    throw(error(model_error(unfold(S, Wish, What)), Location)).

%   wish_place(Files, S, Wish, Place): of the last fact that says so of S; or of
%   any segment, for those of a second file have numbers of their own there.

wish_place(Files, S, Wish, Place) :-
    findall(S1-Place1,
            ( member(File, Files), file_wish_place(File, Wish, S1, Place1) ),
            Places),
    Places \== [],
    (   findall(Place1, member(S-Place1, Places), Own),
        last(Own, Place)
    ->  true
    ;   last(Places, _-Place)
    ).

%   file_wish_place(File, Wish, S, Place) is nondet.

file_wish_place(File, Wish, S, Place) :-
    file_name_extension(_, pl, File),
    exists_file(File),
    with_text(facts, File, Text, wish_places(Text, Wish, Places)),
    member(S-Place, Places).

wish_places(Text, Wish, Places) :-
    next_fact(Text, Fact, Place),
    (   Fact == end_of_file
    ->  Places = []
    ;   Fact = unfolding(S, Said),
        Said == Wish
    ->  Places = [S-Place|Places1],
        wish_places(Text, Wish, Places1)
    ;   wish_places(Text, Wish, Places)
    ).
