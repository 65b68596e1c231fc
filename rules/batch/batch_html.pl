:- encoding(utf8).
:- module(sg_batch_html,
          [ sheet_pages/3               % +File, :Results, +Counts
          ]).
:- use_module(batch_junit, [error_words/2, marked_up/2]).
:- use_module('../language', [language/1]).
:- use_module('../output', [writing/3]).
:- use_module(library(filesex), [relative_file_name/3]).
:- use_module(library(lists), [member/2, sum_list/2]).
:- use_module(library(solution_sequences), [limit/2, offset/2]).
:- use_module(library(uri), [uri_encoded/3]).
/** <module> A merged report as pages of pictures: a contact sheet.
*/

:- meta_predicate sheet_pages(+, 2, +).

%   on_a_page(N): browsers are slow with more pictures.

on_a_page(1000).

%!  sheet_pages(+File, :Results, +Counts) is det.
%
%   Write what call(Results, Dict, Head) gives to File, each job with its
%   picture; what does not fit onto one page goes to FILE-2.html and so on.

sheet_pages(File, Results, Counts) :-
    findall(N, member(_-N, Counts), Ns),
    sum_list(Ns, All),
    on_a_page(Most),
    Pages is max(1, (All+Most-1)//Most),
    forall(between(1, Pages, Page),
           ( page_file(File, Page, Path),
             writing(Path, text,
                     sg_batch_html:page_written(page(File, Page, Pages),
                                                Results, Counts)) )).

page_file(File, 1, File) :-
    !.
page_file(File, Page, Path) :-
    file_name_extension(Base, Ending, File),
    format(atom(Path), '~w-~d.~w', [Base, Page, Ending]).

:- public page_written/4.

page_written(page(File, Page, Pages), Results, Counts, Out) :-
    language(Language),
    word(Language, title, Title),
    page_style(Style),
    format(Out, '<!DOCTYPE html>~n<html lang="~w">~n<head>~n\c
                 <meta charset="utf-8">~n<title>~w</title>~n\c
                 <meta name="viewport" content="width=device-width">~n\c
                 <style>~w</style>~n</head>~n<body>~n<h1>~w</h1>~n',
           [Language, Title, Style, Title]),
    counts_written(Out, Language, Counts),
    pages_written(Out, Language, File, Page, Pages),
    format(Out, '<main>~n', []),
    on_a_page(Most),
    Skip is (Page-1)*Most,
    absolute_file_name(File, Path),
    forall(limit(Most, offset(Skip, call(Results, Dict, Head))),
           job_written(Out, Language, Path, Dict, Head)),
    format(Out, '</main>~n</body>~n</html>~n', []).

page_style('body{font:14px sans-serif;margin:1em}\c
main{display:grid;grid-template-columns:repeat(auto-fill,minmax(220px,1fr));\c
gap:8px}\c
figure{margin:0;padding:4px;border:1px solid #999;overflow-wrap:anywhere}\c
img{width:100%;height:180px;object-fit:contain;background:#fff}\c
figure.failed,figure.timeout,figure.killed{border:3px solid #b00}').

counts_written(Out, Language, Counts) :-
    findall(Text,
            ( member(Outcome-N, Counts),
              N > 0,
              word(Language, Outcome, Word),
              format(atom(Text), '~w ~D', [Word, N]) ),
            Texts),
    atomic_list_concat(Texts, ', ', Text),
    format(Out, '<p>~w</p>~n', [Text]).

pages_written(_, _, _, _, 1) :-
    !.
pages_written(Out, Language, File, Page, Pages) :-
    word(Language, pages, Word),
    format(Out, '<nav>~w:', [Word]),
    forall(between(1, Pages, N),
           (   N =:= Page
           ->  format(Out, ' ~d', [N])
           ;   page_file(File, N, Path),
               file_base_name(Path, Name),
               uri_encoded(path, Name, Address),
               format(Out, ' <a href="~w">~d</a>', [Address, N])
           )),
    format(Out, '</nav>~n', []).

job_written(Out, Language, Page, Dict, head(_, Folder)) :-
    marked_up(Dict.job, Name),
    format(Out, '<figure class="~w">', [Dict.outcome]),
    (   member(Picture, Dict.files),
        shown_ending(Picture)
    ->  address(Page, Folder, Picture, Address),
        format(Out, '<a href="~w"><img src="~w" alt="~w" loading="lazy"></a>',
               [Address, Address, Name])
    ;   true
    ),
    format(Out, '<figcaption>~w', [Name]),
    forall(member(File, Dict.files), file_link(Out, Page, Folder, File)),
    (   memberchk(Dict.outcome, ["done", "cached"])
    ->  true
    ;   atom_string(Outcome, Dict.outcome),
        word(Language, Outcome, Word),
        error_words(Dict, Words0),
        marked_up(Words0, Words),
        format(Out, '<br><b>~w</b> ~w', [Word, Words])
    ),
    format(Out, '</figcaption></figure>~n', []).

shown_ending(File) :-
    file_name_extension(_, Ending, File),
    memberchk(Ending, [svg,png]).

file_link(Out, Page, Folder, File) :-
    address(Page, Folder, File, Address),
    file_name_extension(_, Ending, File),
    marked_up(Ending, Text),
    format(Out, ' <a href="~w">~w</a>', [Address, Text]).

%   address(Page, Folder, File, Address): from the Page to the File of results;
%   those beside the page are meant if there are some, for a folder may have
%   been moved.

address(Page, Folder, File, Address) :-
    file_directory_name(Page, Here),
    atomic_list_concat([Here, /, File], Beside),
    (   exists_file(Beside)
    ->  Path = Beside
    ;   atomic_list_concat([Folder, /, File], Path)
    ),
    relative_file_name(Path, Page, Relative),
    uri_encoded(path, Relative, Encoded),
    marked_up(Encoded, Address).

word(ko, Key, Word) :-
    word_ko(Key, Word),
    !.
word(_, Key, Word) :-
    word_en(Key, Word).

word_en(title, 'Results of a batch').
word_en(pages, 'Pages').
word_en(done, 'done').
word_en(cached, 'cached').
word_en(failed, 'failed').
word_en(timeout, 'out of time').
word_en(killed, 'ended by force').

word_ko(title, '일괄 작업 결과').
word_ko(pages, '쪽').
word_ko(done, '끝남').
word_ko(cached, '이미 있음').
word_ko(failed, '실패').
word_ko(timeout, '시간 초과').
word_ko(killed, '강제로 끝남').
