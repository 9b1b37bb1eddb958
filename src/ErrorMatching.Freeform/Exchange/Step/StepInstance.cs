using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>An instance of a STEP file: one type with its attributes, or several in a complex instance.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Line">Line where it begins.</param>
/// <param name="Records">Its types.</param>
internal sealed record StepInstance(long Id, int Line, IReadOnlyList<StepRecord> Records)
{
    /// <summary>The type of a simple instance; those of a complex one, joined.</summary>
    public string Keyword => Records.Count == 1 ? Records[0].Keyword : $"({string.Join(' ', Records.Select(r => r.Keyword))})";

    /// <summary>The instance in a message.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"#{Id} {Keyword}");

    /// <summary>The attributes of a type; null if the instance has no such type.</summary>
    public StepRecord? Find(string keyword) => Records.FirstOrDefault(r => r.Keyword == keyword);

    /// <summary>The attributes of a type that the instance must have.</summary>
    public StepRecord Get(string keyword) => Find(keyword) ?? throw Records[0].Fail("bad-instance", $"{keyword} is missing in it");

    /// <summary>What the instance is called; empty where it has no name.</summary>
    public string Name
    {
        get
        {
            var record = Find("REPRESENTATION_ITEM") ?? Records[0];
            return record.Values is [{ Kind: StepValueKind.Text, Text: var name }, ..] && name is not "NONE" ? name.Trim() : "";
        }
    }
}
