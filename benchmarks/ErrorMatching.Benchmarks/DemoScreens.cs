using Avalonia;
using ErrorMatching.Hmi;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>The station off screen at a demonstration cell with a mating and a surface, for what is measured on its screens.</summary>
internal static class DemoScreens
{
    /// <summary>Runs a measurement on the station's thread.</summary>
    public static async Task MeasureAsync(Func<DemoCell, Task> measure)
    {
        var folder = Directory.CreateTempSubdirectory("errormatch-station-").FullName;
        try
        {
            await using var cell = DemoCell.Make(folder, TimeProvider.System);
            cell.Run();
            cell.Deliver(1, 0);
            cell.DeliverSurface(1, 0);
            var session = OffScreenSession.Start(() => AppBuilder.Configure<App>());
            await session.RunAsync(() => measure(cell));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
