using System.Reflection;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed class CorrectionCodesTests
{
    [Fact]
    public void Each_code_is_explained()
    {
        var page = File.ReadAllText(Repository.PathTo("docs", "refusals.md"));
        var codes = typeof(CorrectionCodes).GetFields(BindingFlags.Public | BindingFlags.Static)
            .Select(f => (string)f.GetRawConstantValue()!)
            .ToArray();
        Assert.True(codes.Length > 5);
        Assert.All(codes, c => Assert.Contains($"| `{c}` |", page, StringComparison.Ordinal));
    }
}
