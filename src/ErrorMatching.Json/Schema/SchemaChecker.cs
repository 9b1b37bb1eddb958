using System.Globalization;

namespace ErrorMatching.Json;

/// <summary>Applies a rule to a value and its contents.</summary>
internal static class SchemaChecker
{
    public static void Check(SchemaRule rule, JsonItem item, List<Finding> findings)
    {
        // One more than the limit is enough to detect that there are more.
        if (findings.Count > ProblemList.Most)
        {
            return;
        }

        if (rule.Reference is not null)
        {
            Check(rule.Reference, item, findings);
        }

        if (rule.Types.Count > 0 && !rule.Types.Any(t => IsOfType(item, t)))
        {
            findings.Add(new(
                item,
                JsonRefusal.At(item, "wrong-type", ValueText.Of(item), ValueText.Or(rule.Types.Select(ValueText.OfType))),
                ByType: true));
            return;
        }

        if (rule.Values.Count > 0 && !rule.Values.Any(v => IsSame(v, item)))
        {
            var problem = JsonRefusal.At(item, "not-one-of", ValueText.Of(item), ValueText.Or(rule.Values.Select(ValueText.Literal)));
            findings.Add(new(item, problem, ByType: !rule.Values.Any(v => v.Kind == item.Kind), ByConst: rule.IsConst));
            return;
        }

        switch (item.Kind)
        {
            case JsonItemKind.Object:
                CheckObject(rule, item, findings);
                break;
            case JsonItemKind.List:
                CheckList(rule, item, findings);
                break;
            case JsonItemKind.Number:
                CheckNumber(rule, item, findings);
                break;
            case JsonItemKind.Text:
                CheckText(rule, item, findings);
                break;
            default:
                break;
        }

        Alternatives.Check(rule, item, findings);
    }

    private static void CheckObject(SchemaRule rule, JsonItem item, List<Finding> findings)
    {
        foreach (var name in rule.Required.Where(n => item.Find(n) is null))
        {
            Add(findings, item, "missing-key", $"no key \"{name}\"", $"the key \"{name}\"");
        }

        foreach (var member in item.Members)
        {
            if (findings.Count > ProblemList.Most)
            {
                return;
            }

            if (rule.Property(member.Name) is { } property)
            {
                Check(property, member.Value, findings);
            }
            else if (rule.IsClosed)
            {
                var known = rule.Properties.Select(p => p.Key).ToArray();
                var near = NearestName.To(member.Name, known);
                var message = near is null
                    ? $"the key \"{member.Name}\" is not known here; known are {string.Join(", ", known)}."
                    : $"the key \"{member.Name}\" is not known here; did you mean \"{near}\"?";
                findings.Add(new(
                    item,
                    JsonRefusal.At(
                        member.Place,
                        member.Value.Path,
                        "unknown-key",
                        $"the key \"{member.Name}\"",
                        near is null ? ValueText.Or(known) : $"\"{near}\"") with
                    {
                        Message = message
                    }));
            }
        }
    }

    private static void CheckList(SchemaRule rule, JsonItem item, List<Finding> findings)
    {
        if (item.Items.Count < rule.MinItems)
        {
            Add(
                findings,
                item,
                "too-few-items",
                ValueText.Of(item),
                string.Create(CultureInfo.InvariantCulture, $"at least {rule.MinItems}"));
        }

        if (item.Items.Count > rule.MaxItems)
        {
            Add(
                findings,
                item,
                "too-many-items",
                ValueText.Of(item),
                string.Create(CultureInfo.InvariantCulture, $"at most {rule.MaxItems}"));
        }

        for (var i = 0; i < item.Items.Count; i++)
        {
            var itemRule = i < rule.PrefixItems.Count ? rule.PrefixItems[i] : rule.Items;
            if (itemRule is not null)
            {
                Check(itemRule, item.Items[i], findings);
            }
        }
    }

    private static void CheckNumber(SchemaRule rule, JsonItem item, List<Finding> findings)
    {
        var value = item.Number;
        Require(value >= (rule.Minimum ?? value), "too-small", "at least", rule.Minimum);
        Require(value > (rule.ExclusiveMinimum ?? double.NegativeInfinity), "too-small", "more than", rule.ExclusiveMinimum);
        Require(value <= (rule.Maximum ?? value), "too-large", "at most", rule.Maximum);
        Require(value < (rule.ExclusiveMaximum ?? double.PositiveInfinity), "too-large", "less than", rule.ExclusiveMaximum);

        void Require(bool holds, string code, string relation, double? limit)
        {
            if (!holds)
            {
                Add(findings, item, code, ValueText.Of(item), $"{relation} {ValueText.Number(limit ?? 0)}");
            }
        }
    }

    private static void CheckText(SchemaRule rule, JsonItem item, List<Finding> findings)
    {
        if (rule.MinLength is { } least && item.Text.EnumerateRunes().Count() < least)
        {
            Add(
                findings,
                item,
                "too-short",
                ValueText.Of(item),
                least == 1 ? "text that is not empty" : string.Create(CultureInfo.InvariantCulture, $"at least {least} characters"));
        }

        if (rule.Pattern?.IsMatch(item.Text) == false)
        {
            Add(
                findings,
                item,
                "pattern-mismatch",
                ValueText.Of(item),
                rule.Title.Length > 0 ? rule.Title : $"text that matches {rule.Pattern}");
        }
    }

    private static void Add(List<Finding> findings, JsonItem item, string code, string found, string expected) =>
        findings.Add(new(item, JsonRefusal.At(item, code, found, expected)));

    /// <summary>In JSON Schema, a number is an integer if its value is whole, regardless of its spelling.</summary>
    private static bool IsOfType(JsonItem item, string type) => type switch
    {
        "object" => item.Kind == JsonItemKind.Object,
        "array" => item.Kind == JsonItemKind.List,
        "string" => item.Kind == JsonItemKind.Text,
        "number" => item.Kind == JsonItemKind.Number,
        "integer" => item.Kind == JsonItemKind.Number && Math.Floor(item.Number) == item.Number,
        "boolean" => item.Kind == JsonItemKind.Boolean,
        _ => item.Kind == JsonItemKind.Null,
    };

    private static bool IsSame(JsonItem a, JsonItem b) =>
        a.Kind == b.Kind && a.Flag == b.Flag && a.Number == b.Number && (a.Kind == JsonItemKind.Number || a.Text == b.Text);
}
