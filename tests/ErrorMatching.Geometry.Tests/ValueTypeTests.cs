using System.Reflection;
using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry.Tests;

/// <summary>Every public struct is a value: two that were made alike are equal in every way that .NET asks, two that were not are not,
/// and each can be printed.</summary>
public class ValueTypeTests
{
    public static TheoryData<Type> Structs =>
        [.. typeof(Point2).Assembly.GetExportedTypes().Where(t => t is { IsValueType: true, IsEnum: false })];

    [Fact]
    public void All_value_types_are_found() => Assert.True(Structs.Count >= 12);

    [Theory]
    [MemberData(nameof(Structs))]
    public void Equality_is_consistent(Type type)
    {
        var (one, same, other) = (Make(type, 1), Make(type, 1), Make(type, 2));
        Assert.True(one.Equals(same));
        Assert.Equal(one.GetHashCode(), same.GetHashCode());
        Assert.False(one.Equals(other));
        Assert.False(one.Equals(new object()));
        Assert.True(typeof(IEquatable<>).MakeGenericType(type).IsAssignableFrom(type));
        Assert.True(Operator(type, "op_Equality", one, same));
        Assert.False(Operator(type, "op_Equality", one, other));
        Assert.False(Operator(type, "op_Inequality", one, same));
        Assert.True(Operator(type, "op_Inequality", one, other));
    }

    [Theory]
    [MemberData(nameof(Structs))]
    public void Value_can_be_printed(Type type) => Assert.NotEmpty(Make(type, 1).ToString()!);

    [Theory]
    [MemberData(nameof(Structs))]
    public void Struct_is_immutable(Type type)
    {
        Assert.All(type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic), f => Assert.True(f.IsInitOnly));
        Assert.All(
            type.GetProperties(),
            p => Assert.True(p.SetMethod is null || p.SetMethod.ReturnParameter.GetRequiredCustomModifiers().Length > 0));
    }

    private static bool Operator(Type type, string name, object a, object b) =>
        (bool)type.GetMethod(name, [type, type])!.Invoke(null, [a, b])!;

    /// <summary>A value made from its widest constructor, public or not, each argument depending on the seed and its place.</summary>
    private static object Make(Type type, int seed)
    {
        if (type == typeof(double))
        {
            return seed + 0.5;
        }

        if (type == typeof(Vector256<double>))
        {
            return Vector256.Create(seed + 0.5, seed + 1.5, seed + 2.5, seed + 3.5);
        }

        if (type == typeof(int))
        {
            return seed;
        }

        if (type.IsEnum)
        {
            return Enum.GetValues(type).GetValue(seed % Enum.GetValues(type).Length)!;
        }

        var constructor = type.GetConstructors(
            BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).MaxBy(c => c.GetParameters().Length)!;
        return constructor.Invoke([.. constructor.GetParameters().Select((p, i) => Make(p.ParameterType, seed + i))]);
    }
}
