using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Lines with places in braces.</summary>
internal static class TemplateText
{
    /// <summary>The names in braces, in their order.</summary>
    public static IReadOnlyList<string> PlacesOf(string line, Func<Exception> unclosed)
    {
        var places = new List<string>();
        Walk(line, _ => { }, places.Add, unclosed);
        return places;
    }

    /// <summary>The line with its places filled.</summary>
    public static string Fill(string line, Func<string, string> valueOf)
    {
        var text = new StringBuilder();
        Walk(line, c => text.Append(c), place => text.Append(valueOf(place)), () => new InvalidOperationException("The template was not checked."));
        return text.ToString();
    }

    private static void Walk(string line, Action<char> character, Action<string> place, Func<Exception> unclosed)
    {
        for (var i = 0; i < line.Length; i++)
        {
            if (line[i] != '{')
            {
                character(line[i]);
            }
            else if (i + 1 < line.Length && line[i + 1] == '{')
            {
                character('{');
                i++;
            }
            else
            {
                var close = line.IndexOf('}', i);
                if (close < 0)
                {
                    throw unclosed();
                }

                place(line[(i + 1)..close]);
                i = close;
            }
        }
    }
}
