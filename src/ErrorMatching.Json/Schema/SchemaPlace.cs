namespace ErrorMatching.Json;

/// <summary>What a schema says of the values at one place of a document, in all its alternatives together: for forms in which people fill
/// in a document.</summary>
/// <remarks>A place that the schema does not describe has no keys, no words and takes nothing.</remarks>
public sealed class SchemaPlace
{
    // Flat: what a rule refers to and its alternatives are beside it.
    private readonly SchemaRule[] _rules;

    private SchemaPlace(IEnumerable<SchemaRule> rules) => _rules = [.. rules];

    /// <summary>The keys of its objects, in the order of the schema.</summary>
    public IReadOnlyList<string> Keys => [.. _rules.SelectMany(r => r.Properties).Select(p => p.Key).Distinct(StringComparer.Ordinal)];

    /// <summary>The words and numbers that it allows, as JSON spells them without quotes; empty if it does not list them.</summary>
    public IReadOnlyList<string> Words => [.. _rules.SelectMany(r => r.Values).Select(v => v.Text).Distinct(StringComparer.Ordinal)];

    /// <summary>The text or number that holds without the value; empty if there is none.</summary>
    public string Default => _rules.Select(r => r.Default).FirstOrDefault(d => d.Length > 0) ?? "";

    /// <summary>True if a number may stand here.</summary>
    public bool TakesNumbers => Takes("number", JsonItemKind.Number) || Takes("integer", JsonItemKind.Number);

    /// <summary>True if a text may stand here.</summary>
    public bool TakesTexts => Takes("string", JsonItemKind.Text);

    /// <summary>True if <c>true</c> or <c>false</c> may stand here.</summary>
    public bool TakesFlags => Takes("boolean", JsonItemKind.Boolean);

    /// <summary>True if a list may stand here.</summary>
    public bool TakesLists => _rules.Any(r => r.Types.Contains("array"));

    /// <summary>The least number of items of its lists.</summary>
    public int LeastItems => _rules.Max(r => r.MinItems) ?? 0;

    /// <summary>The items of its lists, as far as they are alike.</summary>
    public SchemaPlace Item => Of(_rules.Select(r => r.Items));

    /// <summary>The value of a key of its objects.</summary>
    public SchemaPlace Member(string key) => Of(_rules.Select(r => r.Property(key)));

    /// <summary>True if its objects must have a key, in any of the alternatives.</summary>
    public bool Requires(string key) => _rules.Any(r => r.Required.Contains(key, StringComparer.Ordinal));

    /// <summary>The place with only those alternatives whose constants an object has.</summary>
    /// <param name="textOf">The text that the object has at a key; null or empty if it has none.</param>
    public SchemaPlace Meant(Func<string, string?> textOf)
    {
        ArgumentNullException.ThrowIfNull(textOf);
        return new(_rules.Where(r => r.Properties.All(
            p => !p.Value.IsConst || textOf(p.Key) is not { Length: > 0 } text || p.Value.Values.Any(v => v.Text == text))));
    }

    internal static SchemaPlace Of(IEnumerable<SchemaRule?> rules) => new(rules.OfType<SchemaRule>().SelectMany(All));

    private static IEnumerable<SchemaRule> All(SchemaRule rule) =>
        rule.OneOf.Concat(rule.AnyOf).Concat(rule.Reference is { } target ? [target] : []).SelectMany(All).Prepend(rule);

    private bool Takes(string type, JsonItemKind kind) => _rules.Any(r => r.Types.Contains(type) || r.Values.Any(v => v.Kind == kind));
}
