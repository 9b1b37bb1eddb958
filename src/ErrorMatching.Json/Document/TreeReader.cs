using System.Globalization;
using System.Text;
using System.Text.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Json;

/// <summary>Converts the tokens of a document to items, and collects the problems that do not depend on a schema.</summary>
/// <param name="map">The lines of the document.</param>
/// <param name="file">The file name, for messages.</param>
/// <param name="skipped">Number of bytes before the text: those of a byte order mark.</param>
/// <param name="maxValues">Maximum number of values.</param>
internal sealed class TreeReader(LineMap map, string file, int skipped, int maxValues)
{
    private readonly List<Refusal> _problems = [];
    private int _values;

    public IReadOnlyList<Refusal> Problems => _problems;

    public JsonItem ReadValue(ref Utf8JsonReader reader, ReadOnlySpan<byte> bytes, JsonItem? parent, string? name, int index, int depthLeft)
    {
        var start = (int)reader.TokenStartIndex;
        if (++_values > maxValues)
        {
            var (found, expected) = ("one more value", string.Create(CultureInfo.InvariantCulture, $"at most {maxValues} values"));
            var place = map.PlaceOf(bytes, start);
            throw new InputException(
                file,
                [
                    .. _problems,
                    JsonRefusal.At(place, parent?.Path ?? "$", "too-many-values", found, expected)]);
        }

        var item = ReadItem(ref reader, bytes, parent, name, index, depthLeft);
        item.Bytes = (skipped + start)..(skipped + (int)reader.BytesConsumed);
        return item;
    }

    private JsonItem ReadItem(ref Utf8JsonReader reader, ReadOnlySpan<byte> bytes, JsonItem? parent, string? name, int index, int depthLeft)
    {
        var place = map.PlaceOf(bytes, reader.TokenStartIndex);
        switch (reader.TokenType)
        {
            case JsonTokenType.StartObject:
                return ReadObject(ref reader, bytes, new(JsonItemKind.Object, place, parent, name, index), depthLeft - 1);
            case JsonTokenType.StartArray:
                return ReadList(ref reader, bytes, new(JsonItemKind.List, place, parent, name, index), depthLeft - 1);
            case JsonTokenType.String:
                return ReadText(ref reader, place, parent, name, index);
            case JsonTokenType.Number:
                return ReadNumber(ref reader, place, parent, name, index);
            case JsonTokenType.True or JsonTokenType.False:
                return new(JsonItemKind.Boolean, place, parent, name, index) { Flag = reader.TokenType == JsonTokenType.True };
            default:
                return new(JsonItemKind.Null, place, parent, name, index);
        }
    }

    private JsonItem ReadObject(ref Utf8JsonReader reader, ReadOnlySpan<byte> bytes, JsonItem item, int depthLeft)
    {
        CheckDepth(item, depthLeft);
        var members = new List<JsonMember>();
        var names = new HashSet<string>(StringComparer.Ordinal);
        while (reader.Read() && reader.TokenType != JsonTokenType.EndObject)
        {
            var place = map.PlaceOf(bytes, reader.TokenStartIndex);
            var name = TextOf(ref reader, place, item);
            reader.Read();
            var value = ReadValue(ref reader, bytes, item, name, 0, depthLeft);
            if (names.Add(name))
            {
                members.Add(new(name, place, value));
            }
            else
            {
                Report(JsonRefusal.At(place, item.PathOf(name), "duplicate-key", $"the key \"{name}\" again", "each key once") with
                {
                    Message = $"the key \"{name}\" stands twice in this object; keep one."
                });
            }
        }

        item.Members = members;
        return item;
    }

    private JsonItem ReadList(ref Utf8JsonReader reader, ReadOnlySpan<byte> bytes, JsonItem item, int depthLeft)
    {
        CheckDepth(item, depthLeft);
        var items = new List<JsonItem>();
        while (reader.Read() && reader.TokenType != JsonTokenType.EndArray)
        {
            items.Add(ReadValue(ref reader, bytes, item, null, items.Count, depthLeft));
        }

        item.Items = items;
        return item;
    }

    private JsonItem ReadText(ref Utf8JsonReader reader, JsonPlace place, JsonItem? parent, string? name, int index)
    {
        var item = new JsonItem(JsonItemKind.Text, place, parent, name, index);
        item.Text = TextOf(ref reader, place, item);
        return item;
    }

    private JsonItem ReadNumber(ref Utf8JsonReader reader, JsonPlace place, JsonItem? parent, string? name, int index)
    {
        var spelling = Encoding.UTF8.GetString(reader.ValueSpan);
        var item = new JsonItem(JsonItemKind.Number, place, parent, name, index) { Text = spelling, Number = reader.GetDouble() };
        if (!double.IsFinite(item.Number))
        {
            Report(JsonRefusal.At(item, "number-out-of-range", ValueText.Of(item), "a number that a computer can hold"));
        }

        return item;
    }

    /// <summary>Text of a token. An escaped half of a surrogate pair is not text.</summary>
    private string TextOf(ref Utf8JsonReader reader, JsonPlace place, JsonItem item)
    {
        try
        {
            return reader.GetString()!;
        }
        catch (InvalidOperationException)
        {
            const string expected = "whole characters";
            Report(JsonRefusal.At(item, "not-utf8", "half a surrogate pair", expected) with
            {
                Message = $"found half a surrogate pair (\\uD800 to \\uDFFF); expected {expected}."
            });
            return "";
        }
    }

    private void Report(Refusal problem)
    {
        _problems.Add(problem);
        if (_problems.Count > ProblemList.Most)
        {
            throw new InputException(file, ProblemList.Shortened(_problems));
        }
    }

    private void CheckDepth(JsonItem item, int depthLeft)
    {
        if (depthLeft < 0)
        {
            throw new InputException(
                file, [.. _problems, JsonRefusal.At(item, "too-deep", "one more level", "fewer lists and objects inside one another")]);
        }
    }
}
