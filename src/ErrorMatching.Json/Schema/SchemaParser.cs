using System.Text.RegularExpressions;
using ErrorMatching.Refusals;

namespace ErrorMatching.Json;

/// <summary>Turns a schema document into rules, refusing every keyword that nobody checks.</summary>
internal sealed class SchemaParser(JsonItem document)
{
    private static readonly string[] TypeNames = ["object", "array", "string", "number", "integer", "boolean", "null"];
    private readonly Dictionary<string, SchemaRule> _definitions = new(StringComparer.Ordinal);
    private readonly List<(JsonItem At, SchemaRule Rule, string Target)> _references = [];
    private readonly SchemaRule _root = new();

    public List<Refusal> Problems { get; } = [];

    public SchemaRule Parse()
    {
        Fill(_root, document);
        foreach (var (at, rule, target) in _references)
        {
            var name = target.StartsWith("#/$defs/", StringComparison.Ordinal) ? target["#/$defs/".Length..] : "";
            rule.Reference = target == "#" ? _root : _definitions.GetValueOrDefault(name);
            if (rule.Reference is null)
            {
                Refuse(at, $"a reference to {target}", "# or #/$defs/NAME of this document");
            }
        }

        foreach (var (at, rule, _) in _references)
        {
            if (LeadsBack(rule, rule, []))
            {
                Refuse(at, "a reference that leads back to itself without entering a value", "a reference that ends");
            }
        }

        return _root;
    }

    private SchemaRule ParseRule(JsonItem schema)
    {
        var rule = new SchemaRule();
        Fill(rule, schema);
        return rule;
    }

    private void Fill(SchemaRule rule, JsonItem schema)
    {
        if (Is(schema, JsonItemKind.Object))
        {
            foreach (var member in schema.Members)
            {
                Apply(rule, member);
            }
        }
    }

    private void Apply(SchemaRule rule, JsonMember member)
    {
        if (member.Name is "$schema" or "$id" or "$comment" or "description" or "examples")
        {
            return;
        }

        var (keyword, value) = (member.Name, member.Value);
        if (!SaysWhatItIs(rule, keyword, value) && !SaysParts(rule, keyword, value) && !SaysLimit(rule, keyword, value))
        {
            Problems.Add(JsonRefusal.At(
                member.Place, member.Value.Path, "schema", $"the keyword \"{member.Name}\"", "a keyword that is checked") with
            {
                Message = $"the keyword \"{member.Name}\" is not checked here, so a schema must not use it."
            });
        }
    }

    // What a value is called, and what it is or can be.
    private bool SaysWhatItIs(SchemaRule rule, string keyword, JsonItem value)
    {
        switch (keyword)
        {
            case "title": rule.Title = value.Text; break;
            case "default": rule.Default = value.Text; break;
            case "$defs": Define(value); break;
            case "$ref": _references.Add((value, rule, value.Text)); break;
            case "type": rule.Types = [.. (value.Kind == JsonItemKind.List ? value.Items : [value]).Select(TypeName)]; break;
            case "enum": (rule.Values, rule.IsConst) = (PlainValues(ItemsOf(value)), false); break;
            case "const": (rule.Values, rule.IsConst) = (PlainValues([value]), true); break;
            case "oneOf": rule.OneOf = Rules(value); break;
            case "anyOf": rule.AnyOf = Rules(value); break;
            default: return false;
        }

        return true;
    }

    // What is inside an object or a list.
    private bool SaysParts(SchemaRule rule, string keyword, JsonItem value)
    {
        switch (keyword)
        {
            case "required": rule.Required = [.. ItemsOf(value).Select(i => i.Text)]; break;
            case "properties": rule.Properties = [.. MembersOf(value).Select(p => KeyValuePair.Create(p.Name, ParseRule(p.Value)))]; break;
            case "additionalProperties": rule.IsClosed = Closes(value); break;
            case "items": rule.Items = ParseRule(value); break;
            case "prefixItems": rule.PrefixItems = Rules(value); break;
            default: return false;
        }

        return true;
    }

    private bool SaysLimit(SchemaRule rule, string keyword, JsonItem value)
    {
        switch (keyword)
        {
            case "minItems": rule.MinItems = Count(value); break;
            case "maxItems": rule.MaxItems = Count(value); break;
            case "minLength": rule.MinLength = Count(value); break;
            case "minimum": rule.Minimum = Number(value); break;
            case "maximum": rule.Maximum = Number(value); break;
            case "exclusiveMinimum": rule.ExclusiveMinimum = Number(value); break;
            case "exclusiveMaximum": rule.ExclusiveMaximum = Number(value); break;
            case "pattern": rule.Pattern = Pattern(value); break;
            default: return false;
        }

        return true;
    }

    private void Define(JsonItem value)
    {
        foreach (var definition in MembersOf(value))
        {
            _definitions[definition.Name] = ParseRule(definition.Value);
        }
    }

    private IReadOnlyList<JsonItem> PlainValues(IReadOnlyList<JsonItem> values)
    {
        foreach (var value in values.Where(v => v.Kind is JsonItemKind.List or JsonItemKind.Object))
        {
            Refuse(value, ValueText.Of(value), "a plain value");
        }

        return values;
    }

    private bool Closes(JsonItem value)
    {
        var closes = value is { Kind: JsonItemKind.Boolean, Flag: false };
        if (!closes)
        {
            Refuse(value, ValueText.Of(value), "false");
        }

        return closes;
    }

    private string TypeName(JsonItem value)
    {
        if (!TypeNames.Contains(value.Text, StringComparer.Ordinal))
        {
            Refuse(value, ValueText.Of(value), "the name of a JSON type");
        }

        return value.Text;
    }

    private List<SchemaRule> Rules(JsonItem value) => [.. ItemsOf(value).Select(ParseRule)];

    private IReadOnlyList<JsonItem> ItemsOf(JsonItem value) => Is(value, JsonItemKind.List) ? value.Items : [];

    private IReadOnlyList<JsonMember> MembersOf(JsonItem value) => Is(value, JsonItemKind.Object) ? value.Members : [];

    private int Count(JsonItem value)
    {
        var count = Number(value);
        if (count < 0 || count != Math.Floor(count) || count > int.MaxValue)
        {
            Refuse(value, ValueText.Of(value), "a count");
            return 0;
        }

        return (int)count;
    }

    private double Number(JsonItem value) => Is(value, JsonItemKind.Number) ? value.Number : 0;

    private Regex? Pattern(JsonItem value)
    {
        try
        {
            // A schema is the program's own, so its patterns are trusted to be linear and need no limit by the clock;
            // the non-backtracking engine would take most of a short run to start.
            return new(value.Text, RegexOptions.CultureInvariant, Regex.InfiniteMatchTimeout);
        }
        catch (ArgumentException)
        {
            Refuse(value, ValueText.Of(value), "a regular expression");
            return null;
        }
    }

    private bool Is(JsonItem value, JsonItemKind kind)
    {
        if (value.Kind == kind)
        {
            return true;
        }

        Refuse(value, ValueText.Of(value), ValueText.Of(kind));
        return false;
    }

    private void Refuse(JsonItem at, string found, string expected) => Problems.Add(JsonRefusal.At(at, "schema", found, expected));

    /// <summary>Whether the rules that judge the same value as one rule come back to it: checking would never end.</summary>
    private static bool LeadsBack(SchemaRule from, SchemaRule to, HashSet<SchemaRule> seen)
    {
        IEnumerable<SchemaRule> next = [
            .. from.OneOf, .. from.AnyOf, .. from.Reference is null ? Array.Empty<SchemaRule>() : [from.Reference]];
        return next.Any(r => ReferenceEquals(r, to) || (seen.Add(r) && LeadsBack(r, to, seen)));
    }
}
