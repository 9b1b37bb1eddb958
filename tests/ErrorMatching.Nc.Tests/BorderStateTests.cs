using System.Collections;
using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// What a run remembers lies in many objects, and a run takes over another one's motions where it stands as that one did. Each field of
/// each object must be seen by that comparison, or be one that no cut
/// reads. A new field is neither until somebody has thought about it.
/// </summary>
public sealed class BorderStateTests
{
    // What is written before it is read in each block, what only other blocks than cuts read, and what is counted beside.
    private static readonly string[] NoCutReads =
    [
        "BlockIntent.Code", "BlockIntent.Family", "BlockIntent.Probes", "BlockIntent.Reference", "BlockIntent.Use",
        "BlockIntent.AboutPole", "BlockIntent.NamesMotion", "BlockIntent.NeedsSense",
        "ControlRefusals._stops", "BlockIntent.CallsTool", "BlockIntent.Oversize", "CalledTool.Oversize", "CalledTool.Radius",
        "Corners._pending.Item2", "CannedCycles._initial", "CannedCycles._unknown", "CannedCycles._words.Item1",
        "CannedCycles._pecksVary", "PolarEnds._pole",
        "CannedCycles._words.Item2", "CannedCycles._words.Item3", "CannedCycles._words.Item4", "BoreRetraction._shift",
        "NcControl.Offset", "IntegerWords.Count", "IntegerWords._first", "RunResult.Block",
        "OriginShift.Stored.Item1.X", "OriginShift.Stored.Item1.Y", "OriginShift.Stored.Item1.Z", "OriginShift.Stored.Item2",
        "OriginShift.Local.Item1.X", "OriginShift.Local.Item1.Y", "OriginShift.Local.Item1.Z", "OriginShift.Local.Item2",
        "OriginShift.Unknown", "OriginShift.Vector.X", "OriginShift.Vector.Y", "OriginShift.Vector.Z",
        "ProgramTransforms.Inverse", "ProgramTransforms.Programmable", "ProgramTransforms.Rotation", "ProgramTransforms.Scale",
        "ProgramTransforms._isFlat", "ProgramTransforms._opaqueFamilies",
        "ToolLength.Vector.X", "ToolLength.Vector.Y", "ToolLength.Vector.Z", "ToolLength._isInInches",
        "ToolLength.FromTable", "ToolLength.IsUnsure", "ProgramTransforms.AreUnsure",
        "WorkOffsets.Chosen.Item1", "WorkOffsets.Chosen.Item2", "WorkOffsets.IsUnsure",
        "BlockExecutor.HasOnlyModes", "ForkLimits._left", "Forks.Trace", "Forks._next", "Forks._seen", "ProgramRun.Decide",
        "ProgramRun.At", "ProgramRun.HasEnded", "ProgramRun.Holes", "ProgramRun.Returned", "ProgramRun._flow",
        "RunBorders.OnlyCuts", "RunBorders._jumps", "RunBorders._next", "RunBorders._problems", "SecondCore.Seam", "SecondCore._ahead",
    ];

    private static readonly NcProgram Cuts = NcProgram.FromText(string.Join('\n', "G0 X1. Y2. Z3.", "G1 X4. F100.", "Y7.5",
        "G2 X6. Y9.5 R2.", "G3 X4. Y7.5 I0. J-2.", "G1 Z-1. F50.", "X1"));

    public static TheoryData<string> Fields => [.. Places(Run()).Select(p => p.Name)];

    [Fact]
    public void The_list_names_only_fields_that_there_are() =>
        Assert.Empty(NoCutReads.Except(Places(Run()).Select(p => p.Name), StringComparer.Ordinal));

    [Theory]
    [MemberData(nameof(Fields))]
    public void The_comparison_sees_each_field_that_a_cut_reads(string name)
    {
        var run = Run();
        var state = run.State;
        Assert.True(run.Borders.StandsAs(state));

        Places(run).Single(p => p.Name == name).Change();

        Assert.Equal(NoCutReads.Contains(name, StringComparer.Ordinal), run.Borders.StandsAs(state));
        if (run.Borders.StandsAs(state))
        {
            Assert.Equal(Motions(Run()), Motions(run));
        }
    }

    private static NcInterpreter Run() => new(Cuts, NcDialects.FanucMill, new(), null, CancellationToken.None);

    private static NcMotion[] Motions(NcInterpreter run)
    {
        run.RunCuts(run.State, 0, Cuts.BlockCount);
        Assert.Equal(Cuts.BlockCount, run.At);
        return [.. run.Motions];
    }

    // All that can change in the objects of a run, to the last number of its structs. Lists and tables are those of results and of what
    // other blocks than cuts look up.
    private static List<(string Name, Action Change)> Places(NcInterpreter run)
    {
        var (found, seen, open) =
            (new List<(string, Action)>(), new HashSet<object>(ReferenceEqualityComparer.Instance), new Queue<object>([run]));
        while (open.TryDequeue(out var owner))
        {
            if (!seen.Add(owner))
            {
                continue;
            }

            foreach (var field in owner.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                var value = field.GetValue(owner);
                if (value is not null && IsPartOfRun(value))
                {
                    open.Enqueue(value);
                }
                else if (!field.IsInitOnly && !field.Name.EndsWith('P')
                    && value is not (ICollection or NcMotions or NcProgram or NcDialect or BlockWords))
                {
                    found.AddRange(Parts($"{owner.GetType().Name}.{NameOf(field)}", field.FieldType, value, other =>
                        field.SetValue(owner, other)));
                }
            }
        }

        return found;
    }

    private static bool IsPartOfRun(object value) =>
        value.GetType() is { IsClass: true } type && type.Assembly == typeof(NcInterpreter).Assembly
            && value is not (NcMotions or NcProgram or NcDialect or BlockWords or MulticastDelegate);

    // A property's field, and a field.
    private static string NameOf(FieldInfo field) => field.Name.StartsWith('<')
        ? field.Name[1..field.Name.IndexOf('>', StringComparison.Ordinal)] : field.Name;

    private static IEnumerable<(string Name, Action Change)> Parts(string name, Type type, object? value, Action<object?> set)
    {
        if (Nullable.GetUnderlyingType(type) is null && type is { IsValueType: true, IsPrimitive: false, IsEnum: false })
        {
            return type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).SelectMany(f =>
                Parts($"{name}.{NameOf(f)}", f.FieldType, f.GetValue(value), part =>
            {
                var copy = value;
                f.SetValue(copy, part);
                set(copy);
            }));
        }

        return [(name, () => set(Another(name, type, value)))];
    }

    private static object? Another(string name, Type type, object? value) => value switch
    {
        bool v => !v,
        byte v => (byte)(v + 1),
        int v => v - 1,
        long v => v + 1,
        ulong v => v + 1,
        double v => Math.BitIncrement(v),
        Enum v => Enum.GetValues(type).Cast<Enum>().First(other =>
            Convert.ToInt64(other, CultureInfo.InvariantCulture) != Convert.ToInt64(v, CultureInfo.InvariantCulture)),
        null => Something(name, Nullable.GetUnderlyingType(type) ?? type),
        MulticastDelegate => null,
        _ => throw new InvalidOperationException($"{name} is {value}: say here what differs from it."),
    };

    // An object that has not been filled is something else than none.
    private static object Something(string name, Type type) =>
        type == typeof(NcFlow) ? new NcFlow(Cuts, NcDialects.FanucMill)
        : type.IsGenericType && type.GetGenericTypeDefinition() == typeof(Task<>)
            ? typeof(Task).GetMethod(nameof(Task.FromResult))!.MakeGenericMethod(type.GenericTypeArguments).Invoke(null, [null])!
        : type.IsInterface || type.IsAbstract
            ? throw new InvalidOperationException($"{name} is of the type {type}: say here what could stand there.")
        : RuntimeHelpers.GetUninitializedObject(type);
}
