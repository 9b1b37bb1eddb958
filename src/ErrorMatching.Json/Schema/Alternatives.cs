namespace ErrorMatching.Json;

/// <summary>Checks oneOf and anyOf. Reports the problems of the alternative that was probably intended, not of all of them.</summary>
internal static class Alternatives
{
    public static void Check(SchemaRule rule, JsonItem item, List<Finding> findings)
    {
        if (rule.AnyOf.Count > 0)
        {
            Judge(rule.AnyOf, item, findings);
        }

        if (rule.OneOf.Count > 0 && Judge(rule.OneOf, item, findings) > 1)
        {
            findings.Add(new(
                item,
                JsonRefusal.At(
                    item,
                    "several-alternatives",
                    ValueText.Of(item) + " that could mean several things",
                    "exactly one of " + ValueText.Or(rule.OneOf.Select(Name)))));
        }
    }

    /// <summary>Returns the number of alternatives that accept the value. Reports the problems if none does.</summary>
    private static int Judge(IReadOnlyList<SchemaRule> alternatives, JsonItem item, List<Finding> findings)
    {
        var verdicts = alternatives.Select(a => Verdict(a, item)).ToArray();
        var accepted = verdicts.Count(v => v.Count == 0);
        if (accepted == 0)
        {
            // Alternatives of another type were not intended, unless all are.
            var ofType = verdicts.Where(v => !v.Exists(f => IsOfOtherType(f, item))).ToArray();
            Explain(alternatives, ofType.Length > 0 ? ofType : verdicts, item, findings);
        }

        return accepted;
    }

    private static List<Finding> Verdict(SchemaRule rule, JsonItem item)
    {
        var findings = new List<Finding>();
        SchemaChecker.Check(rule, item, findings);
        return findings;
    }

    private static void Explain(IReadOnlyList<SchemaRule> alternatives, List<Finding>[] verdicts, JsonItem item, List<Finding> findings)
    {
        var meant = verdicts.Where(v => !v.Exists(f => RulesOut(f, item))).ToArray();
        if (meant.Length == 1)
        {
            findings.AddRange(meant[0]);
            return;
        }

        // A problem common to all remaining alternatives is certain, such as a missing "kind".
        var common = meant.Length == 0 ? [] : meant[0].Where(f => meant.All(v => v.Contains(f))).ToList();
        if (common.Count > 0)
        {
            findings.AddRange(common);
            return;
        }

        var ruledOut = verdicts.Select(v => v.FirstOrDefault(f => RulesOut(f, item))).Where(f => f.Item is not null).ToArray();
        if (meant.Length == 0 && ruledOut.All(f => ReferenceEquals(f.Item, ruledOut[0].Item)))
        {
            var (place, first) = (ruledOut[0].Item, ruledOut[0].Problem);
            var all = JsonRefusal.At(place, first.Code, first.Found, ValueText.Or(ruledOut.Select(f => f.Problem.Expected)));
            // A value that may be a word or something else, such as "auto" or a number, does not identify the kind of its object.
            findings.Add(new(place, all, ruledOut.All(f => f.ByType), ruledOut.All(f => f.ByConst) && !ReferenceEquals(place, item)));
            return;
        }

        findings.Add(new(item, JsonRefusal.At(item, "no-alternative", ValueText.Of(item), ValueText.Or(alternatives.Select(Name)))));
    }

    /// <summary>True if an alternative was not intended: another type of value, or another const in it or in one of its members.</summary>
    private static bool RulesOut(Finding finding, JsonItem item) =>
        IsOfOtherType(finding, item)
            || (finding.ByConst && (ReferenceEquals(finding.Item, item) || item.Members.Any(m => ReferenceEquals(m.Value, finding.Item))));

    private static bool IsOfOtherType(Finding finding, JsonItem item) => finding.ByType && ReferenceEquals(finding.Item, item);

    private static string Name(SchemaRule rule) => rule switch
    {
        { Title.Length: > 0 } => rule.Title,
        { Reference: { } target } => Name(target),
        { Values.Count: > 0 } => ValueText.Or(rule.Values.Select(ValueText.Literal)),
        { Types.Count: > 0 } => ValueText.Or(rule.Types.Select(ValueText.OfType)),
        _ => "another form",
    };
}
