using BenchmarkDotNet.Running;
using ErrorMatching.Benchmarks;

if (args is ["whole-process"])
{
    return WholeProcess.Run();
}

if (args is ["compensate"])
{
    return DenseCompensation.Run();
}

if (args is ["rs274", .. var blocks])
{
    return PeerBenchmark.Run(blocks.FirstOrDefault());
}

if (args is ["real"])
{
    return RealPrograms.Run();
}

if (args is ["million", .. var million])
{
    return MillionBlocks.Run(million.FirstOrDefault());
}

if (args is ["compensated", .. var contour])
{
    return CompensatedBlocks.Run(contour.FirstOrDefault());
}

if (args is ["huge"])
{
    return HugeFiles.Run();
}

if (args is ["corrections", var place, .. var corrections])
{
    return MillionCorrections.Run(place, corrections.FirstOrDefault());
}

if (args is ["toolpath"])
{
    return ToolPathBenchmark.Run();
}

if (args is ["fits", .. var points])
{
    return SurfaceFitTimes.Run(points.FirstOrDefault());
}

if (args is ["station", .. var station])
{
    return await StationFrames.RunAsync(station.FirstOrDefault());
}

if (args is ["plots", .. var plots])
{
    return await PlotFrames.RunAsync(plots.FirstOrDefault());
}

if (args is ["frames"])
{
    return await ScreenFrames.RunAsync();
}

if (args is ["display"])
{
    return await DisplayFrames.RunAsync();
}

if (args is ["display-window"])
{
    return DisplayFrames.Show();
}

if (args is ["screens", .. var screens])
{
    return await StationScreens.RunAsync(screens);
}

if (args is ["fit-once", var shape, var count, var noise])
{
    return SurfaceFitTimes.Once(shape, count, noise);
}

BenchmarkSwitcher.FromAssembly(typeof(MatchBenchmarks).Assembly).Run(args);
return 0;
