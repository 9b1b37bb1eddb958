namespace ErrorMatching.Hmi;

/// <summary>What a stable code of the cell or of a reader means, in the language of the screen.</summary>
public static class CodeText
{
    /// <summary>
    /// The text of a code; where the station has none of its own, the sentence that came with it. One that it cannot say in the language of the screen stands behind what its code means: it names blocks, points and numbers.
    /// </summary>
    public static string Of(string code, string? otherwise) => Texts.Current.Or("Code." + code, otherwise is null ? code : Sentence(code, otherwise));

    private static string Sentence(string code, string sentence)
    {
        var said = RecordedText.Of(sentence);
        return said != sentence || Texts.Current.Language == Language.English || Texts.Current.Or("Meaning." + code, "") is not { Length: > 0 } meaning
            ? said
            : Texts.Current.With("Meaning.WithSentence", meaning, sentence);
    }
}
