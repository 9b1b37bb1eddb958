using System.Globalization;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using System.Text.RegularExpressions;
using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>A JSON object while it is edited by paths such as <c>$.gauge.uncertaintyMm</c>. Whatever nobody types stays as it was read.
/// Immutable.</summary>
/// <remarks>A typed text becomes the value that the schema wants at its place. A text that reads otherwise than it was typed, such as
/// <c>06.</c> or one with a space at its end, is kept as an object with the one key <c>typed</c> until the job is written.</remarks>
[JsonConverter(typeof(Converter))]
public sealed partial class DraftDocument
{
    private const string Typed = "typed";

    // Never changed: an edit clones it.
    private readonly JsonObject _root;

    internal DraftDocument(JsonObject root) => _root = root;

    /// <summary>Nothing is typed.</summary>
    internal static DraftDocument Empty { get; } = new([]);

    /// <summary>The text at a path: as typed, or as JSON spells it; the texts of a list with commas between them. Empty if there is
    /// none.</summary>
    internal string this[string path] => TextOf(Find(path));

    /// <summary>The number of items of the list at a path; 0 if there is none.</summary>
    internal int Count(string path) => Find(path) is JsonArray list ? list.Count : 0;

    /// <summary>The members of the object at a path, or the items of the list there with empty names.</summary>
    internal IEnumerable<(string Name, string Text)> Parts(string path) => Find(path) switch
    {
        JsonObject typed when TypedIn(typed) is { } text => DraftList.Names(text).Select(t => ("", t)),
        JsonObject members => members.Select(m => (m.Key, TextOf(m.Value))),
        JsonArray items => items.Select(i => ("", TextOf(i))),
        _ => [],
    };

    /// <summary>A copy of the whole object.</summary>
    internal JsonObject Copy() => (JsonObject)_root.DeepClone();

    /// <summary>The document with another text at a path. An empty text takes the key away, and objects that it leaves empty.</summary>
    /// <param name="place">What the schema says of the whole object.</param>
    /// <param name="path">The path.</param>
    /// <param name="text">The text as typed.</param>
    internal DraftDocument With(SchemaPlace place, string path, string text) => Changed(place, path, (at, _) =>
    {
        var value = text.Length == 0 ? null : ValueOf(at, path[(path.LastIndexOf('.') + 1)..], text);
        return value is null || TextOf(value) == text ? value : new JsonObject { [Typed] = text };
    });

    /// <summary>The document with what another one has at a path, or without it.</summary>
    internal DraftDocument With(SchemaPlace place, string path, DraftDocument? from) =>
        Changed(place, path, (_, _) => from?.Find(path)?.DeepClone());

    /// <summary>The document with one more item, an empty object, at the end of a list.</summary>
    internal DraftDocument WithItem(SchemaPlace place, string list) => Changed(
        place, list, (_, was) => new JsonArray([.. was is JsonArray items ? items.Select(i => i?.DeepClone()) : [], new JsonObject()]));

    /// <summary>The document without an item of a list, and without the list if it was the last.</summary>
    internal DraftDocument WithoutItem(SchemaPlace place, string list, int index) => Changed(place, list, (_, was) =>
    {
        var items = (JsonArray)was!.DeepClone();
        items.RemoveAt(index);
        return items.Count > 0 ? items : null;
    });

    /// <summary>The object as a file has it: with the values that typed texts mean, without blank ones that may be missing and without
    /// keys of another alternative than the chosen one, and with an empty value for each key that is required.</summary>
    /// <param name="value">The object. It is changed.</param>
    /// <param name="place">What the schema says of it.</param>
    internal static void Finish(JsonObject value, SchemaPlace place)
    {
        var keys = place.Keys;
        Complete(value, place, p => p.Words.Count > 0 && !p.TakesLists);
        var meant = place.Meant(k => TextOf(value[k]));
        foreach (var (key, member) in value.Where(m => m.Value is not null).ToArray())
        {
            if (keys.Contains(key) && !meant.Keys.Contains(key))
            {
                value.Remove(key);
            }
            else if (Finished(member!, key, meant.Member(key)) is not { } finished)
            {
                value.Remove(key);
            }
            else if (!ReferenceEquals(finished, member))
            {
                value[key] = finished;
            }
        }

        Complete(value, meant, _ => true);
    }

    /// <summary>What the schema says of the value at a path.</summary>
    /// <param name="place">What it says of the whole object.</param>
    /// <param name="path">The path.</param>
    internal static SchemaPlace PlaceOf(SchemaPlace place, string path) =>
        StepsOf(path).Aggregate(place, (at, step) => step.Name is { } name ? at.Member(name) : at.Item);

    private static void Complete(JsonObject value, SchemaPlace place, Func<SchemaPlace, bool> isMeant)
    {
        foreach (var key in place.Keys.Where(k => place.Requires(k) && !value.ContainsKey(k)).ToArray())
        {
            if (place.Member(key) is var member && isMeant(member))
            {
                Put(value, place, key, Blank(key, member));
            }
        }
    }

    // What stands for a value that is required and not typed yet.
    private static JsonNode Blank(string key, SchemaPlace place)
    {
        if (place.TakesLists && !place.TakesNumbers)
        {
            return place.Item.TakesNumbers
                ? new JsonArray([.. Enumerable.Repeat("", place.LeastItems).Select(t => JsonValue.Create(t))]) : new JsonArray();
        }

        if (place.Keys.Count > 0)
        {
            var value = new JsonObject();
            Finish(value, place);
            return value;
        }

        return ValueOf(place, key, place.Words.Count > 0 ? place.Words[0] : "");
    }

    // Null for a blank text that may be missing.
    private static JsonNode? Finished(JsonNode value, string key, SchemaPlace place)
    {
        switch (value)
        {
            case JsonObject typed when TypedIn(typed) is { } text:
                return string.IsNullOrWhiteSpace(text) ? null : ValueOf(place, key, text);
            case JsonObject members:
                var wasEmpty = members.Count == 0;
                Finish(members, place);
                return members.Count > 0 || wasEmpty ? members : null;
            case JsonArray items:
                for (var i = 0; i < items.Count; i++)
                {
                    if (items[i] is { } item && (Finished(item, key, place.Item) ?? "") is var finished && !ReferenceEquals(finished, item))
                    {
                        items[i] = finished;
                    }
                }

                return items;
            default:
                return value;
        }
    }

    // The value that the schema wants where a text was typed. A text that is no number stays one: the job's reader says so.
    private static JsonNode ValueOf(SchemaPlace place, string key, string text) =>
        place.TakesNumbers && DraftNumber.Json(text) is { } number ? JsonNode.Parse(number)!
        : place.TakesFlags && bool.TryParse(text, out var flag) ? JsonValue.Create(flag)
        : place.TakesLists && !place.TakesNumbers && !place.TakesTexts
            ? new JsonArray([.. DraftList.Items(key, text).Select(t => JsonValue.Create(t))])
        : JsonValue.Create(text.Trim());

    private static string TextOf(JsonNode? value) => value switch
    {
        null => "",
        JsonObject typed when TypedIn(typed) is { } text => text,
        JsonArray items when items.All(i => i is JsonValue) => DraftList.Join(items.Select(TextOf)),
        JsonObject or JsonArray => value.ToJsonString(),
        _ => value.GetValueKind() is JsonValueKind.True ? "true" : value.GetValueKind() is JsonValueKind.False ? "false" : value.ToString(),
    };

    private static string? TypedIn(JsonObject value) =>
        value.Count == 1 && value[Typed] is JsonValue typed && typed.GetValueKind() == JsonValueKind.String ? typed.ToString() : null;

    private static IEnumerable<Step> StepsOf(string path) => StepForm().Matches(path).Select(m => new Step(
        m.Groups["name"] is { Success: true } name ? name.Value : null,
        m.Groups["index"] is { Success: true } index ? int.Parse(index.Value, CultureInfo.InvariantCulture) : 0));

    // In the order of the schema; behind all others if the schema does not know it.
    internal static void Put(JsonObject value, SchemaPlace place, string key, JsonNode member)
    {
        if (value.ContainsKey(key))
        {
            value[key] = member;
            return;
        }

        var later = place.Keys.SkipWhile(k => k != key).ToHashSet(StringComparer.Ordinal);
        var at = value.Select(m => m.Key).TakeWhile(k => !later.Contains(k)).Count();
        value.Insert(at, key, member);
    }

    private JsonNode? Find(string path)
    {
        JsonNode? at = _root;
        foreach (var step in StepsOf(path))
        {
            at = step.Name is { } name
                ? (at as JsonObject)?[name] : at is JsonArray items && step.Index < items.Count ? items[step.Index] : null;
        }

        return at;
    }

    private DraftDocument Changed(SchemaPlace place, string path, Func<SchemaPlace, JsonNode?, JsonNode?> change) =>
        new(Changed(Copy(), place, [.. StepsOf(path)], change) as JsonObject ?? []);

    // The value that replaces one, given as a copy, when something in it changes; null for none.
    private static JsonNode? Changed(
        JsonNode? value, SchemaPlace place, ReadOnlySpan<Step> path, Func<SchemaPlace, JsonNode?, JsonNode?> change)
    {
        if (path.IsEmpty)
        {
            return change(place, value);
        }

        if (path[0].Name is { } name)
        {
            var members = value as JsonObject is { } was && TypedIn(was) is null ? was : null;
            var member = Changed(members?[name]?.DeepClone(), place.Member(name), path[1..], change);
            if (members is null && member is null)
            {
                return value;
            }

            members ??= [];
            if (member is null)
            {
                members.Remove(name);
            }
            else
            {
                Put(members, place, name, member);
            }

            return members.Count > 0 ? members : null;
        }

        var (items, index) = (value as JsonArray, path[0].Index);
        var item = Changed(items?.ElementAtOrDefault(index)?.DeepClone(), place.Item, path[1..], change);
        if (items is null && item is null)
        {
            return value;
        }

        items ??= [];
        while (items.Count < Math.Max(index + 1, place.LeastItems))
        {
            items.Add((JsonNode)"");
        }

        items[index] = item ?? (items[index] is JsonObject ? new JsonObject() : "");
        return items.All(i => i is JsonValue && i.ToString().Length == 0) ? null : items;
    }

    [GeneratedRegex(
        @"(?<name>(?<=\.)[^.\[\]]+)|\[(?<index>[0-9]{1,9})\]",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex StepForm();

    /// <summary>A step of a path: into a key, or into an item of a list.</summary>
    private readonly record struct Step(string? Name, int Index);

    /// <summary>Stores the object as it is.</summary>
    internal sealed class Converter : JsonConverter<DraftDocument>
    {
        public override DraftDocument Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) =>
            JsonNode.Parse(ref reader) is JsonObject root ? new(root) : throw new JsonException("A draft is an object.");

        public override void Write(Utf8JsonWriter writer, DraftDocument value, JsonSerializerOptions options) =>
            value._root.WriteTo(writer);
    }
}
