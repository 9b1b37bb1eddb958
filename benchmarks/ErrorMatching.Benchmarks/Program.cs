using BenchmarkDotNet.Running;
using ErrorMatching.Benchmarks;

if (args is ["whole-process", .. var rest])
{
    return WholeProcess.Run(rest.FirstOrDefault());
}

if (args is ["rs274", .. var blocks])
{
    return PeerBenchmark.Run(blocks.FirstOrDefault());
}

if (args is ["million", .. var million])
{
    return MillionBlocks.Run(million.FirstOrDefault());
}

if (args is ["huge"])
{
    return HugeFiles.Run();
}

if (args is ["toolpath"])
{
    return ToolPathBenchmark.Run();
}

BenchmarkSwitcher.FromAssembly(typeof(MatchBenchmarks).Assembly).Run(args);
return 0;
