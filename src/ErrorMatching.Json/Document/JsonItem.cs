using System.Globalization;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.Json;

/// <summary>A value of a JSON document with its location: its path from the root, its line and its column.</summary>
/// <remarks>Immutable once read. Members keep the order of the document.</remarks>
public sealed class JsonItem
{
    private readonly JsonItem? _parent;
    private readonly string? _name;
    private readonly int _index;

    internal JsonItem(JsonItemKind kind, JsonPlace place, JsonItem? parent, string? name, int index)
    {
        (Kind, Place, _parent, _name, _index) = (kind, place, parent, name, index);
    }

    /// <summary>What kind of value it is.</summary>
    public JsonItemKind Kind { get; }

    /// <summary>Where the value starts.</summary>
    public JsonPlace Place { get; }

    /// <summary>The byte range of the value in the document.</summary>
    public Range Bytes { get; internal set; }

    /// <summary>The characters of a text, or the spelling of a number; otherwise empty.</summary>
    public string Text { get; internal set; } = "";

    /// <summary>The value of a number, always finite; otherwise zero.</summary>
    public double Number { get; internal init; }

    /// <summary>The value of a Boolean; otherwise false.</summary>
    public bool Flag { get; internal init; }

    /// <summary>The items of a list; otherwise empty.</summary>
    public IReadOnlyList<JsonItem> Items { get; internal set; } = [];

    /// <summary>The members of an object in the document's order; otherwise empty.</summary>
    public IReadOnlyList<JsonMember> Members { get; internal set; } = [];

    /// <summary>The path from the root: <c>$.features[1].toleranceMm</c>. A key that is not a plain word is quoted: <c>$['odd
    /// key']</c>.</summary>
    public string Path =>
        _parent is null
            ? "$"
            : _name is null
            ? string.Create(CultureInfo.InvariantCulture, $"{_parent.Path}[{_index}]")
            : PathOf(_name, _parent);

    /// <summary>The value of a required member.</summary>
    /// <exception cref="KeyNotFoundException">The member is missing. A schema that requires it makes this impossible.</exception>
    public JsonItem this[string name] => Find(name) ?? throw new KeyNotFoundException($"{Path} has no key \"{name}\".");

    /// <summary>The value of a member; null if it is missing.</summary>
    public JsonItem? Find(string name)
    {
        foreach (var member in Members)
        {
            if (member.Name == name)
            {
                return member.Value;
            }
        }

        return null;
    }

    /// <summary>The path of a member of this object, whether it exists or not.</summary>
    public string PathOf(string name) => PathOf(name, this);

    /// <summary>The value as strict JSON on one line, without the document's comments and trailing commas.</summary>
    public string ToJson()
    {
        using var buffer = new MemoryStream();
        using (var writer = new Utf8JsonWriter(buffer))
        {
            WriteTo(writer);
        }

        return Encoding.UTF8.GetString(buffer.ToArray());
    }

    /// <summary>The value in words, for messages: <c>the text "lime"</c>, <c>a list of 3</c>.</summary>
    public override string ToString() => ValueText.Of(this);

    private static string PathOf(string name, JsonItem parent) => IsPlainWord(name)
        ? $"{parent.Path}.{name}"
        : $"{parent.Path}['{name.Replace("\\", "\\\\", StringComparison.Ordinal).Replace("'", "\\'", StringComparison.Ordinal)}']";

    private static bool IsPlainWord(string name) =>
        name.Length > 0 && !char.IsAsciiDigit(name[0]) && name.All(c => char.IsAsciiLetterOrDigit(c) || c is '_' or '$');

    private void WriteTo(Utf8JsonWriter writer)
    {
        switch (Kind)
        {
            case JsonItemKind.Object:
                writer.WriteStartObject();
                foreach (var member in Members)
                {
                    writer.WritePropertyName(member.Name);
                    member.Value.WriteTo(writer);
                }

                writer.WriteEndObject();
                break;
            case JsonItemKind.List:
                writer.WriteStartArray();
                foreach (var item in Items)
                {
                    item.WriteTo(writer);
                }

                writer.WriteEndArray();
                break;
            case JsonItemKind.Text:
                writer.WriteStringValue(Text);
                break;
            case JsonItemKind.Number:
                writer.WriteRawValue(Text);
                break;
            case JsonItemKind.Boolean:
                writer.WriteBooleanValue(Flag);
                break;
            default:
                writer.WriteNullValue();
                break;
        }
    }
}
