using System.Reflection;
using Xunit.Sdk;
using Xunit.v3;

namespace ErrorMatching.Score;

/// <summary>One test of another project, with its arguments, to be called directly.</summary>
/// <param name="Method">Its method.</param>
/// <param name="Arguments">Its arguments.</param>
internal sealed record TestCase(MethodInfo Method, object?[] Arguments)
{
    public string Name => $"{Method.DeclaringType!.Name}.{Method.Name}({string.Join(", ", Arguments)})".ReplaceLineEndings(" ");

    /// <summary>All tests of some classes of an assembly, in the order of the classes.</summary>
    /// <exception cref="InvalidOperationException">There is no such class.</exception>
    public static IEnumerable<TestCase> In(Assembly assembly, IEnumerable<string> classes) => classes
        .Select(name => assembly.GetTypes().SingleOrDefault(type => type.Name == name)
            ?? throw new InvalidOperationException($"There are no {name}."))
        .SelectMany(type => type.GetMethods())
        .Where(method => method.GetCustomAttributes().OfType<IFactAttribute>().Any(fact => fact.Skip is null && !fact.Explicit))
        .SelectMany(Of);

    /// <summary>Throws what the test throws.</summary>
    public async Task RunAsync()
    {
        var instance = Activator.CreateInstance(Method.DeclaringType!);
        try
        {
            if (instance is IAsyncLifetime lifetime)
            {
                await lifetime.InitializeAsync().ConfigureAwait(false);
            }

            var arguments = Method.ResolveMethodArguments(Arguments);
            if (Method.Invoke(instance, BindingFlags.DoNotWrapExceptions, null, arguments, null) is { } result)
            {
                await (result is ValueTask task ? task.AsTask() : (Task)result).ConfigureAwait(false);
            }
        }
        finally
        {
            (instance as IDisposable)?.Dispose();
            if (instance is IAsyncDisposable disposable)
            {
                await disposable.DisposeAsync().ConfigureAwait(false);
            }
        }
    }

    private static IEnumerable<TestCase> Of(MethodInfo method)
    {
        var attributes = method.GetCustomAttributes().ToArray();
        if (!attributes.Any(attribute => attribute is IDataAttribute))
        {
            return [new(method, [])];
        }

        var cases = attributes.SelectMany(attribute => attribute switch
        {
            InlineDataAttribute inline => [inline.Data],
            MemberDataAttribute member => Rows(method.DeclaringType!, member),
            _ => Array.Empty<object?[]>(),
        }).Select(arguments => new TestCase(method, arguments)).ToArray();
        return cases.Length > 0 ? cases : throw new InvalidOperationException($"{method.Name} has no data.");
    }

    private static IEnumerable<object?[]> Rows(Type type, MemberDataAttribute member)
    {
        const BindingFlags Static = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;
        var owner = member.MemberType ?? type;
        var data = owner.GetProperty(member.MemberName, Static)?.GetValue(null)
            ?? owner.GetMethod(member.MemberName, Static)!.Invoke(null, member.Arguments);
        return ((System.Collections.IEnumerable)data!).Cast<object>().Select(row => row as object?[] ?? ((ITheoryDataRow)row).GetData());
    }
}
