using ErrorMatching.Testing;

namespace ErrorMatching.Measurement.Tests;

public class PublicApiTests
{
    [Fact]
    public void Public_api_is_the_one_of_the_snapshot() => PublicApi.MatchesSnapshot(typeof(MeasurementReader).Assembly);
}
