using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>The form of a recorded statement: its code and its English sentence, with a place for each value. What is recorded is the code
/// and the values (<see cref="Statement"/>); sentences are made where they are shown.</summary>
public sealed class SentenceForm
{
    /// <summary>Kind of a value that is one of a few words, which have translations.</summary>
    public const string Word = "word";

    /// <summary>Kind of a value that is the state of something, as a word.</summary>
    public const string State = "state";

    private const string Several = "list";
    private readonly string[] _words;

    /// <summary>Creates a form.</summary>
    /// <param name="name">Its stable name, which is the code of its statements, such as <c>sparse-points</c>.</param>
    /// <param name="template">Its words, with the places <c>{0}</c>, <c>{1}</c> and so on in order. After a colon follows the kind of the
    /// value: a format of numbers or times, <c>word</c>, <c>state</c>, or <c>list</c> with the separator of several statements.</param>
    /// <exception cref="ArgumentException">The name is not a code, or the places are not numbered in order.</exception>
    public SentenceForm(string name, string template)
    {
        ArgumentNullException.ThrowIfNull(template);
        if (!StatementText.IsCode(name))
        {
            throw new ArgumentException($"\"{name}\" is not a code.", nameof(name));
        }

        (Name, Template) = (name, template);
        var (words, kinds) = (new List<string>(), new List<string>());
        var at = 0;
        for (int open; (open = template.IndexOf('{', at)) >= 0;)
        {
            var close = template.IndexOf('}', open);
            var (number, kind) = template[(open + 1)..close].Split(':', 2) is [var n, var k] ? (n, k) : (template[(open + 1)..close], "");
            if (number != kinds.Count.ToString(CultureInfo.InvariantCulture))
            {
                throw new ArgumentException($"Place {number} of \"{template}\" is out of order.", nameof(template));
            }

            words.Add(template[at..open]);
            kinds.Add(kind);
            at = close + 1;
        }

        words.Add(template[at..]);
        (_words, Kinds) = ([.. words], kinds);
    }

    /// <summary>Its name: the code of its statements, by which translations find it.</summary>
    public string Name { get; }

    /// <summary>Its words with places.</summary>
    public string Template { get; }

    /// <summary>The kind of each value; empty for a name, a text or a statement that is shown as it is.</summary>
    public IReadOnlyList<string> Kinds { get; }

    /// <summary>Makes a statement.</summary>
    /// <param name="values">Names and texts, statements or lists of them, and numbers and times, which are recorded exactly.</param>
    /// <exception cref="ArgumentException">There are more or fewer values than places.</exception>
    public Statement With(params ReadOnlySpan<object?> values)
    {
        if (values.Length != Kinds.Count)
        {
            throw new ArgumentException($"{Name} has {Kinds.Count} places; there are {values.Length} values.", nameof(values));
        }

        var stated = new Statement[values.Length];
        for (var i = 0; i < stated.Length; i++)
        {
            stated[i] = ValueOf(values[i]).Within(Statement.MostDepth - 1);
        }

        return Statement.Of(Name, stated, this);
    }

    /// <summary>The separator of several statements; null if the kind is another one.</summary>
    /// <param name="kind">The kind of a value.</param>
    public static string? SeparatorOf(string kind)
    {
        ArgumentNullException.ThrowIfNull(kind);
        return kind.StartsWith(Several, StringComparison.Ordinal) ? kind[Several.Length..] : null;
    }

    /// <summary>A number or a time in the form's format; null if the kind is not a format, or the value is neither.</summary>
    /// <param name="kind">The kind of the value.</param>
    /// <param name="value">The value as recorded.</param>
    public static string? Formatted(string kind, string value) => kind switch
    {
        ['0', ..] when long.TryParse(value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var whole) =>
            whole.ToString(kind, CultureInfo.InvariantCulture),
        ['0', ..] when double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) =>
            number.ToString(kind, CultureInfo.InvariantCulture),
        ['y', ..] when DateTimeOffset.TryParseExact(value, "O", CultureInfo.InvariantCulture, DateTimeStyles.None, out var time) =>
            time.UtcDateTime.ToString(kind, CultureInfo.InvariantCulture),
        _ => null,
    };

    /// <summary>The English sentence with these values.</summary>
    internal string Sentence(IReadOnlyList<Statement> values) =>
        string.Concat(_words.Select((w, i) => i == 0 ? w : Shown(Kinds[i - 1], values[i - 1]) + w));

    private static string Shown(string kind, Statement value) =>
        SeparatorOf(kind) is { } separator ? string.Join(separator, value.Parts.Select(p => p.Sentence))
        : value.Words is { } text ? Formatted(kind, text) ?? text
        : value.Sentence;

    private static Statement ValueOf(object? value) => value switch
    {
        Statement statement => statement,
        IEnumerable<Statement> several => Statement.InARow(several),
        double number => number.ToString("R", CultureInfo.InvariantCulture),
        DateTimeOffset time => time.ToUniversalTime().ToString("O", CultureInfo.InvariantCulture),
        _ => Convert.ToString(value, CultureInfo.InvariantCulture) ?? "",
    };
}
