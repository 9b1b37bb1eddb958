namespace ErrorMatching.Testing;

/// <summary>The sentences of a catalog, one code with its sentence in a line, in ordinal order. A test compares them with a file beside it,
/// so that the wording is pinned once and other tests look at codes and values; with UPDATE_SENTENCES=1 in the environment, the test writes
/// that file instead.</summary>
internal static class SentenceList
{
    public static void Matches(IEnumerable<(string Code, string Sentence)> catalog, params string[] file)
    {
        var path = Repository.PathTo(["tests", .. file]);
        var actual = string.Concat(catalog.OrderBy(c => c.Code, StringComparer.Ordinal).Select(c => $"{c.Code}: {c.Sentence}\n"));
        if (Environment.GetEnvironmentVariable("UPDATE_SENTENCES") == "1") File.WriteAllText(path, actual);
        Assert.Equal(File.ReadAllText(path), actual);
    }
}
