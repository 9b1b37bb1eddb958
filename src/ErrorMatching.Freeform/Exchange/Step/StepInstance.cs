using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>An instance of a STEP file: one type with its attributes, or several types in a complex instance.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Line">Line where it starts.</param>
/// <param name="Records">Its types.</param>
internal sealed record StepInstance(long Id, int Line, IReadOnlyList<StepRecord> Records)
{
    /// <summary>The type of a simple instance; the joined types of a complex one.</summary>
    public string Keyword => Records.Count == 1 ? Records[0].Keyword : $"({string.Join(' ', Records.Select(r => r.Keyword))})";

    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"#{Id} {Keyword}");

    /// <summary>The attributes of a type; null if the instance has no such type.</summary>
    public StepRecord? Find(string keyword) => Records.FirstOrDefault(r => r.Keyword == keyword);

    /// <summary>The attributes of a required type.</summary>
    public StepRecord Get(string keyword) => Find(keyword) ?? throw Records[0].Fail("bad-instance", $"{keyword} is missing in it");

    /// <summary>The instance's name; empty if it has none.</summary>
    public string Name
    {
        get
        {
            var record = Find("REPRESENTATION_ITEM") ?? Records[0];
            return record.Values is [{ Kind: StepValueKind.Text, Text: var name }, ..] && name is not "NONE" ? name.Trim() : "";
        }
    }
}
