using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed class RecordedSentencesTests
{
    [Fact]
    public void What_a_cell_records_has_its_sentences() => SentenceList.Matches(
        Recorded.All.Select(f => (f.Name, f.Template)), "ErrorMatching.Cell.Tests", "Evidence", "recorded-sentences.txt");
}
