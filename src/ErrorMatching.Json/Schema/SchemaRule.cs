using System.Text.RegularExpressions;

namespace ErrorMatching.Json;

/// <summary>One schema object with its parsed keywords. Null or empty means that the keyword is absent.</summary>
internal sealed class SchemaRule
{
    public string Title { get; set; } = "";

    /// <summary>A default that is a text or a number; it is not checked.</summary>
    public string Default { get; set; } = "";

    public IReadOnlyList<string> Types { get; set; } = [];

    /// <summary>The allowed values of enum or const.</summary>
    public IReadOnlyList<JsonItem> Values { get; set; } = [];

    /// <summary>True if <see cref="Values"/> is from const, which distinguishes alternatives.</summary>
    public bool IsConst { get; set; }

    public IReadOnlyList<string> Required { get; set; } = [];

    public IReadOnlyList<KeyValuePair<string, SchemaRule>> Properties { get; set; } = [];

    public bool IsClosed { get; set; }

    public SchemaRule? Items { get; set; }

    public IReadOnlyList<SchemaRule> PrefixItems { get; set; } = [];

    public int? MinItems { get; set; }

    public int? MaxItems { get; set; }

    public double? Minimum { get; set; }

    public double? Maximum { get; set; }

    public double? ExclusiveMinimum { get; set; }

    public double? ExclusiveMaximum { get; set; }

    public int? MinLength { get; set; }

    public Regex? Pattern { get; set; }

    public IReadOnlyList<SchemaRule> OneOf { get; set; } = [];

    public IReadOnlyList<SchemaRule> AnyOf { get; set; } = [];

    public SchemaRule? Reference { get; set; }

    public SchemaRule? Property(string name)
    {
        foreach (var (key, rule) in Properties)
        {
            if (key == name)
            {
                return rule;
            }
        }

        return null;
    }
}
