namespace ErrorMatching.Hmi;

/// <summary>What a stable code of the cell means, in the language of the screen.</summary>
public static class CodeText
{
    /// <summary>The text of a code; where the station has none of its own, the sentence that came with it.</summary>
    public static string Of(string code, string? otherwise) => Texts.Current.Or("Code." + code, otherwise ?? code);
}
