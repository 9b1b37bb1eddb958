using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>A template of a recorded sentence, with placeholders for values. The same template writes a sentence and reads its values
/// back, so that it can be shown in another language without changing the record.</summary>
public sealed class SentenceForm
{
    private readonly string[] _words;

    /// <summary>Creates a template.</summary>
    /// <param name="name">Its stable name, such as <c>sparse-points</c>.</param>
    /// <param name="template">Its words, with the placeholders <c>{0}</c>, <c>{1}</c> and so on in order. After a colon follows the kind
    /// of value, or a number format.</param>
    /// <exception cref="ArgumentException">The placeholders are not numbered in order, or two are adjacent.</exception>
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
                throw new ArgumentException(
                    $"Place {number} of \"{template}\" is out of order or follows another one at once.", nameof(template));
            }

            words.Add(template[at..open]);
            kinds.Add(kind);
            at = close + 1;
        }

        words.Add(template[at..]);
        (_words, Kinds) = ([.. words], kinds);
    }

    /// <summary>Its name, by which translations find it.</summary>
    public string Name { get; }

    /// <summary>Its words with placeholders.</summary>
    public string Template { get; }

    /// <summary>The kind of each value; empty for a name or text that is shown unchanged.</summary>
    public IReadOnlyList<string> Kinds { get; }

    /// <summary>Writes a sentence. Numbers are culture-independent.</summary>
    public string With(params ReadOnlySpan<object?> values) => string.Format(CultureInfo.InvariantCulture, Template, values);

    /// <summary>Returns the values of a sentence; null if the sentence does not match. A value is never empty, and ends at the first
    /// occurrence of the following words.</summary>
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
            // The last words match at the end, wherever else they occur.
            var next = i == _words.Length - 1
                ? end
                : at < end
                ? sentence.IndexOf(_words[i], at + 1, end - at - 1, StringComparison.Ordinal)
                : -1;
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
