using System.Text.Json;

namespace ErrorMatching.Freeform.Tests;

public sealed class FitMethodTests
{
    [Fact]
    public void The_schema_names_the_ways_of_fitting()
    {
        using var schema = JsonDocument.Parse(FreeformTemplate.Schema);
        var named = schema.RootElement.GetProperty("properties")
            .GetProperty("fit")
            .GetProperty("properties")
            .GetProperty("method")
            .GetProperty("enum");
        Assert.Equal(FitMethod.All.Select(m => m.Name), named.EnumerateArray().Select(n => n.GetString()));
    }

    [Fact]
    public void Each_name_leads_to_its_way_and_no_other_does() => Assert.Multiple(
        () => Assert.All(FitMethod.All, m => Assert.Same(m, FitMethod.Named(m.Name))),
        () => Assert.Null(FitMethod.Named("Best")));
}
