using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceSentencesTests
{
    [Fact]
    public void Warnings_have_their_sentences() => SentenceList.Matches(
        SurfaceWarningForms.All.Select(f => (f.Name, f.Template)), "ErrorMatching.Freeform.Tests", "Reporting", "sentences.txt");
}
