using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>
/// A form of a sentence that is kept as evidence: its words, and places for values. The same form writes a sentence and reads the values back from it, so that who shows it may say it in another language while the record stays as it is.
/// </summary>
public sealed class SentenceForm
{
    private readonly string[] _words;

    /// <summary>A form.</summary>
    /// <param name="name">Its stable name, such as <c>sparse-points</c>.</param>
    /// <param name="template">Its words, with <c>{0}</c>, <c>{1}</c> and so on in this order. Behind a colon stands what kind of value it is, or a number's format.</param>
    /// <exception cref="ArgumentException">The places are not numbered in their order, or two stand side by side.</exception>
    public SentenceForm(string name, string template)
    {
        ArgumentNullException.ThrowIfNull(template);
        (Name, Template) = (name, template);
        var (words, kinds) = (new List<string>(), new List<string>());
        var at = 0;
        for (int open; (open = template.IndexOf('{', at)) >= 0;)
        {
            var close = template.IndexOf('}', open);
            var (number, kind) = template[(open + 1)..close].Split(':', 2) is [var n, var k] ? (n, k) : (template[(open + 1)..close], "");
            if (number != kinds.Count.ToString(CultureInfo.InvariantCulture) || (open == at && kinds.Count > 0))
            {
                throw new ArgumentException($"Place {number} of \"{template}\" is out of order or follows another one at once.", nameof(template));
            }

            words.Add(template[at..open]);
            kinds.Add(kind);
            at = close + 1;
        }

        words.Add(template[at..]);
        (_words, Kinds) = ([.. words], kinds);
    }

    /// <summary>Its stable name.</summary>
    public string Name { get; }

    /// <summary>Its words with the places of the values.</summary>
    public string Template { get; }

    /// <summary>Of what kind each value is; empty for a name or text that is shown as it is.</summary>
    public IReadOnlyList<string> Kinds { get; }

    /// <summary>Writes a sentence. Numbers are written without any culture.</summary>
    public string With(params ReadOnlySpan<object?> values) => string.Format(CultureInfo.InvariantCulture, Template, values);

    /// <summary>The values of a sentence of this form; null if it has another one. A value is never empty, and ends where the words behind it are found first.</summary>
    public IReadOnlyList<string>? Read(string sentence)
    {
        ArgumentNullException.ThrowIfNull(sentence);
        if (_words.Length == 1)
        {
            return sentence == _words[0] ? [] : null;
        }

        if (!sentence.StartsWith(_words[0], StringComparison.Ordinal) || !sentence.EndsWith(_words[^1], StringComparison.Ordinal))
        {
            return null;
        }

        var (values, at, end) = (new List<string>(), _words[0].Length, sentence.Length - _words[^1].Length);
        for (var i = 1; i < _words.Length; i++)
        {
            // The last words are those at the end, wherever else they stand.
            var next = i == _words.Length - 1 ? end : at < end ? sentence.IndexOf(_words[i], at + 1, end - at - 1, StringComparison.Ordinal) : -1;
            if (next <= at)
            {
                return null;
            }

            values.Add(sentence[at..next]);
            at = next + _words[i].Length;
        }

        return values;
    }
}
