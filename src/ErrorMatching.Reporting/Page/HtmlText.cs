using System.Text;

namespace ErrorMatching.Reporting;

/// <summary>Writes markup that is HTML and well-formed XML at once. Whatever is written as text or as an attribute is escaped.</summary>
public sealed class HtmlText
{
    private readonly StringBuilder _text = new("<!DOCTYPE html>\n");

    /// <summary>Opens an element; disposing of the result closes it. Attributes without a value are left out.</summary>
    public HtmlScope In(string element, params ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        Start(element, attributes);
        _text.Append('>');
        return new(this, element);
    }

    /// <summary>An element that holds text only.</summary>
    public void Put(string element, string content, params ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        using (In(element, attributes))
        {
            Text(content);
        }
    }

    /// <summary>An element that holds nothing.</summary>
    public void Empty(string element, params ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        Start(element, attributes);
        _text.Append(" />");
        EndLineAfter(element);
    }

    /// <summary>Text.</summary>
    public void Text(ReadOnlySpan<char> content) => HtmlEscape.Append(_text, content);

    /// <summary>The style sheet, which is ours and free of markup characters.</summary>
    public void Style(string css) => _text.Append("<style>\n").Append(css).Append("</style>\n");

    /// <summary>UTF-8 without a byte order mark.</summary>
    public byte[] ToBytes() => Encoding.UTF8.GetBytes(_text.ToString());

    internal void End(string element)
    {
        _text.Append("</").Append(element).Append('>');
        EndLineAfter(element);
    }

    private void Start(string element, ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        _text.Append('<').Append(element);
        foreach (var (name, value) in attributes)
        {
            if (value is not null)
            {
                _text.Append(' ').Append(name).Append("=\"");
                HtmlEscape.Append(_text, value);
                _text.Append('"');
            }
        }
    }

    // A line end between blocks can be seen by nobody but a reader of the source; within a sentence or a block of a program it would be a space.
    private void EndLineAfter(string element)
    {
        if (element is not ("a" or "code" or "del" or "em" or "ins" or "span" or "strong" or "title" or "tspan"))
        {
            _text.Append('\n');
        }
    }
}
