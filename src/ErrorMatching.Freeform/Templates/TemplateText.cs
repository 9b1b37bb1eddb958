using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Finds and fills placeholders in braces.</summary>
internal static class TemplateText
{
    /// <summary>The names in braces, in order.</summary>
    public static IReadOnlyList<string> PlacesOf(string line, Func<Exception> unclosed)
    {
        var places = new List<string>();
        Walk(line, _ => { }, places.Add, unclosed);
        return places;
    }

    /// <summary>Writes lines with their placeholders filled, including only the branches of conditions that apply.</summary>
    /// <param name="text">The output.</param>
    /// <param name="items">The lines.</param>
    /// <param name="holds">Evaluates a condition.</param>
    /// <param name="valueOf">Returns the value of a placeholder.</param>
    /// <param name="finish">Makes a filled line one of the program.</param>
    /// <param name="each">Writes the lines of a loop.</param>
    /// <param name="refuse">Makes an error of a reason not to touch a point.</param>
    public static void Write(
        StringBuilder text,
        IReadOnlyList<TemplateItem> items,
        Func<string, bool> holds,
        Func<string, string> valueOf,
        Func<string, string> finish,
        Action<IReadOnlyList<TemplateItem>> each,
        Func<TemplateItem, Exception>? refuse = null)
    {
        foreach (var item in items)
        {
            switch (item.Kind)
            {
                case TemplateItemKind.Each:
                    each(item.Body);
                    break;
                case TemplateItemKind.If:
                    Write(text, holds(item.Text) ? item.Body : item.Else, holds, valueOf, finish, each, refuse);
                    break;
                case TemplateItemKind.Refuse when refuse is not null:
                    throw refuse(item);
                default:
                    text.Append(finish(Fill(item.Text, valueOf))).Append('\n');
                    break;
            }
        }
    }

    public static string Fill(string line, Func<string, string> valueOf)
    {
        var text = new StringBuilder();
        Walk(
            line,
            c => text.Append(c),
            place => text.Append(valueOf(place)),
            () => new InvalidOperationException("The template was not checked."));
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
