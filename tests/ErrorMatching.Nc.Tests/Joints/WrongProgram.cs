using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>The smallest programs that once came out with a proof that did not hold.</summary>
internal static class WrongProgram
{
    /// <summary>One of them, interpreted.</summary>
    public static NcPath Read(string name, string dialect)
    {
        var bytes = File.ReadAllBytes(Repository.PathTo("tests", "ErrorMatching.Nc.Tests", "Joints", name));
        var named = NcDialects.Named(dialect);
        return NcInterpreter.Run(NcProgram.Read(bytes, named.Syntax), named);
    }
}
