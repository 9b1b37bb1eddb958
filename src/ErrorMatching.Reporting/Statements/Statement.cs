using System.Diagnostics.CodeAnalysis;

namespace ErrorMatching.Reporting;

/// <summary>What is recorded of something: a code with its values, the words of a person or of another program, or several of these in a
/// row. Sentences are made of it where it is shown. Two statements are equal if they are recorded alike.</summary>
public sealed class Statement : IEquatable<Statement>
{
    /// <summary>Maximum depth of statements within statements.</summary>
    public const int MostDepth = 8;

    private const int FewestCut = 16;
    private string? _code;
    private IReadOnlyList<Statement> _values;
    private string? _words;
    private SentenceForm? _form;
    private string? _text;

    // The forms to read the text with, as long as nobody has asked what is in it: most entries of a long trail are only compared.
    private IReadOnlyDictionary<string, SentenceForm>? _unread;

    private Statement(string? code, IReadOnlyList<Statement> values, string? words, SentenceForm? form) =>
        (_code, _values, _words, _form) = (code, values, words, form);

    /// <summary>The code; empty for several statements in a row, null for words.</summary>
    public string? Code => Read()._code;

    /// <summary>The values of the code, or the statements in a row; none for words.</summary>
    public IReadOnlyList<Statement> Values => Read()._values;

    /// <summary>The words; null for a code or several statements.</summary>
    public string? Words => Read()._words;

    /// <summary>The form of the code; null if it is not known here, or the statement has another number of values.</summary>
    public SentenceForm? Form => Read()._form;

    /// <summary>True if it has a code, or one of several in a row has.</summary>
    public bool IsCoded => Code is { Length: > 0 } || (Code is not null && Values.Any(v => v.IsCoded));

    /// <summary>The statements in a row; the statement itself if it is a single one.</summary>
    public IReadOnlyList<Statement> Parts => Code is "" ? Values : [this];

    /// <summary>How it is recorded: see <see cref="StatementText"/>.</summary>
    public string Text => _text ??= StatementText.Of(this);

    /// <summary>The English sentence, or the words. The sentence of an unknown code is the code with its values.</summary>
    public string Sentence => Words ?? (
        Form is not null ? Form.Sentence(Values)
        : Code is "" ? string.Join(' ', Values.Select(v => v.Sentence).Where(s => s.Length > 0))
        : Values.Count == 0 ? Code!
        : $"{Code}: {string.Join("; ", Values.Select(v => v.Sentence))}");

    private int Depth => Values.Count == 0 ? (Words is null ? 1 : 0) : 1 + Values.Max(v => v.Depth);

    /// <summary>The words of a person or of another program.</summary>
    /// <param name="words">The words; null for no statement.</param>
    [return: NotNullIfNotNull(nameof(words))]
    public static Statement? OfWords(string? words) => words is null ? null : new(null, [], words, null);

    /// <summary>Several statements, one sentence after the other. Empty words are left out.</summary>
    /// <param name="statements">The statements.</param>
    public static Statement InARow(params IEnumerable<Statement> statements)
    {
        ArgumentNullException.ThrowIfNull(statements);
        Statement[] parts = [.. statements.SelectMany(s => s.Parts).Where(s => s.Words is not "")];
        return parts switch
        {
            [] => "",
            [var only] => only,
            _ => new("", [.. parts.Select(p => p.Within(MostDepth - 1))], null, null),
        };
    }

    /// <summary>True if the statement has a form.</summary>
    /// <param name="form">The form.</param>
    public bool Is(SentenceForm form) => form is not null && Code == form.Name && Form is not null;

    /// <summary>Reads what is recorded. What is not a statement, such as the sentences of earlier versions, is words.</summary>
    /// <param name="text">The recorded text.</param>
    /// <param name="forms">The known forms by their names.</param>
    public static Statement Read(string text, IReadOnlyDictionary<string, SentenceForm> forms)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(forms);
        return StatementText.IsMarked(text)
            ? new Statement(null, [], null, null) { _text = text, _unread = forms }
            : text;
    }

    /// <summary>The statement with all its texts cut so that its recorded text has at most so many characters.</summary>
    /// <param name="most">The most characters; at least 16.</param>
    public Statement Fitted(int most)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(most, FewestCut);
        for (var cut = most; cut >= FewestCut; cut /= 2)
        {
            if (Cut(cut) is var shorter && shorter.Text.Length <= most)
            {
                return shorter;
            }
        }

        return OfWords(Sentence).Cut(most);
    }

    /// <summary>Words are statements, too.</summary>
    /// <param name="words">The words.</param>
    [return: NotNullIfNotNull(nameof(words))]
    public static implicit operator Statement?(string? words) => OfWords(words);

    /// <summary>True if both are recorded alike.</summary>
    public static bool operator ==(Statement? one, Statement? other) => one is null ? other is null : one.Equals(other);

    /// <summary>True if they are recorded differently.</summary>
    public static bool operator !=(Statement? one, Statement? other) => !(one == other);

    /// <inheritdoc/>
    public bool Equals(Statement? other) => other is not null && Text == other.Text;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => Equals(obj as Statement);

    /// <inheritdoc/>
    public override int GetHashCode() => StringComparer.Ordinal.GetHashCode(Text);

    /// <summary>The English sentence.</summary>
    public override string ToString() => Sentence;

    internal static Statement Of(string code, IReadOnlyList<Statement> values, SentenceForm? form) =>
        new(code, values, null, form?.Kinds.Count == values.Count ? form : null);

    // Several threads may do this at once, with the same result.
    private Statement Read()
    {
        if (Volatile.Read(ref _unread) is not { } forms) return this;
        try
        {
            var read = StatementText.Read(_text!, forms);
            (_code, _values, _words, _form) = (read._code, read._values, read._words, read._form);
        }
        catch (FormatException)
        {
            // It stays what it is, to the last character: hashes cover it.
            _words = _text;
        }

        Volatile.Write(ref _unread, null);
        return this;
    }

    /// <summary>The statement, or its sentence as words if it is deeper.</summary>
    internal Statement Within(int depth) => Depth <= depth ? this : Sentence;

    private Statement Cut(int most) =>
        Words is { Length: var length } words && length > most ? words[..(most - 1)] + "…"
        : Values.Count == 0 ? this
        : new(Code, [.. Values.Select(v => v.Cut(most))], null, Form);
}
